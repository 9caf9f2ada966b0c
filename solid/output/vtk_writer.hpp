// SPDX-License-Identifier: GPL-3.0-or-later
// VTK files for ParaView: blocks.pvd with blocks, joints and water of every frame as its parts.
#pragma once

#include <filesystem>
#include <memory>

#include "solid/output/frame.hpp"

namespace blockweir::solid::output {

class VtkWriter {
 public:
  /// Files go to `folder`/frames, the collection to `folder`/blocks.pvd.
  explicit VtkWriter(std::filesystem::path folder);
  ~VtkWriter();
  VtkWriter(const VtkWriter&) = delete;
  VtkWriter& operator=(const VtkWriter&) = delete;

  /// Adds a frame. Throws std::runtime_error when a file cannot be written.
  void write(const Frame& frame);

 private:
  struct Files;
  std::filesystem::path folder_;
  std::string entries_;
  int count_ = 0;
  std::unique_ptr<Files> files_;
};

}  // namespace blockweir::solid::output
