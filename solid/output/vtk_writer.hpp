// SPDX-License-Identifier: GPL-3.0-or-later
// VTK files for ParaView: blocks.pvd with blocks, joints and water of every frame.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/vtk/collection.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid::output {

class VtkWriter {
 public:
  /// Frames are written to `folder`/frames, the collection to `folder`/blocks.pvd.
  explicit VtkWriter(const std::filesystem::path& folder);

  /// Adds a frame. Throws std::runtime_error if a file cannot be written.
  void write(const Frame& frame);
  /// A warning of frames that a resumed run does not find again; empty if all are there.
  [[nodiscard]] const std::string& lost() const { return files_.lost(); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(files_, count_, without_contacts_);
  }

 private:
  vtk::Collection files_;
  int count_ = 0;
  std::string without_contacts_;  ///< the first file of joints that is empty: it serves again
};

}  // namespace blockweir::solid::output
