// SPDX-License-Identifier: GPL-3.0-or-later
// A ParaView collection (.pvd): a list of VTK files with their times and parts.
#pragma once

#include <filesystem>
#include <future>
#include <string>

#include "bridge/results/closed_file.hpp"
#include "bridge/vtk/grid.hpp"
#include "bridge/vtk/xml.hpp"

namespace blockweir::vtk {

class Collection {
 public:
  /// The collection is `folder`/`name`; its VTK files are in `folder`/frames.
  Collection(std::filesystem::path folder, const std::string& name);

  /// Writes `grid` as frames/`file` and adds it to the list. Throws std::runtime_error if the file cannot be written,
  /// or if VTK is not there.
  void add(const Grid& grid, const std::string& file, double time_s, const char* part, int part_number = 0);
  /// Adds an existing file to the list again, for a time at which nothing has changed.
  void repeat(const std::string& file, double time_s, const char* part, int part_number = 0);
  /// Writes the list. Throws std::runtime_error if it cannot be written; the previous one then remains.
  void save();
  [[nodiscard]] bool has(const std::string& file) const { return std::filesystem::exists(folder_ / "frames" / file); }
  /// A warning of files that a resumed run does not find again, which the list leaves out; empty if all are there.
  [[nodiscard]] const std::string& lost() const { return lost_; }

  template <class Archive>
  void save(Archive& archive) const {
    archive(entries_);
  }
  template <class Archive>
  void load(Archive& archive) {
    archive(entries_);
    look_for_files();
  }

 private:
  void look_for_files();

  std::filesystem::path folder_;
  std::string entries_;  ///< of all that was written
  std::string listed_;   ///< of all that is there
  std::string lost_;
  results::ClosedFile list_;
  /// Opening VTK takes longer than many a window: it is done beside other work, and is over before the program ends.
  std::shared_future<XmlFunction*> xml_;
};

}  // namespace blockweir::vtk
