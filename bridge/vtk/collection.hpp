// SPDX-License-Identifier: GPL-3.0-or-later
// A ParaView collection (.pvd): VTK files with the times and parts that they stand for.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "bridge/results/closed_file.hpp"
#include "bridge/vtk/grid.hpp"

namespace blockweir::vtk {

class Collection {
 public:
  /// The collection goes to `folder`/`name`, its files to `folder`/frames.
  Collection(std::filesystem::path folder, const std::string& name);
  ~Collection();
  Collection(const Collection&) = delete;
  Collection& operator=(const Collection&) = delete;

  /// Writes `grid` as frames/`file` and lists it. Throws std::runtime_error when the file cannot be written.
  void add(const Grid& grid, const std::string& file, double time_s, const char* part, int part_number = 0);
  /// Lists a file that is there already once more: nothing has changed since.
  void repeat(const std::string& file, double time_s, const char* part, int part_number = 0);
  /// Puts the list on disk. Throws std::runtime_error when it cannot be written, and leaves the former one.
  void save();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(entries_);
  }

 private:
  struct Writer;
  std::filesystem::path folder_;
  std::string entries_;
  results::ClosedFile list_;
  std::unique_ptr<Writer> writer_;
};

}  // namespace blockweir::vtk
