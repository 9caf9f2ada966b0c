// SPDX-License-Identifier: GPL-3.0-or-later
// VTK files for ParaView: blocks.pvd with blocks, joints and water of every frame as its parts.
#pragma once

#include <filesystem>

#include "bridge/vtk/collection.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid::output {

class VtkWriter {
 public:
  /// Files go to `folder`/frames, the collection to `folder`/blocks.pvd.
  explicit VtkWriter(const std::filesystem::path& folder);

  /// Adds a frame. Throws std::runtime_error when a file cannot be written.
  void write(const Frame& frame);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(files_, count_);
  }

 private:
  vtk::Collection files_;
  int count_ = 0;
};

}  // namespace blockweir::solid::output
