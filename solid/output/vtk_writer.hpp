// SPDX-License-Identifier: GPL-3.0-or-later
// VTK files for ParaView: blocks.pvd with blocks, joints and water of every frame.
#pragma once

#include <filesystem>
#include <future>
#include <string>

#include "bridge/vtk/collection.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid::output {

class VtkWriter {
 public:
  /// Frames are written to `folder`/frames, the collection to `folder`/blocks.pvd.
  explicit VtkWriter(const std::filesystem::path& folder);

  /// Adds a frame. Files of many blocks are written beside what follows. Throws std::runtime_error if one of this frame
  /// or of the one before could not be written.
  void write(const Frame& frame);
  /// Waits for the files. Throws std::runtime_error if one could not be written.
  void finish();
  /// A warning of frames that a resumed run does not find again; empty if all are there.
  [[nodiscard]] const std::string& lost() const { return files_.lost(); }

  template <class Archive>
  void serialize(Archive& archive) {
    finish();
    archive(files_, count_, without_contacts_);
  }

 private:
  void write_files(const Frame& frame);

  vtk::Collection files_;
  int count_ = 0;
  std::string without_contacts_;  ///< the first file of joints that is empty: it serves again
  std::future<void> writing_;     ///< last: is over before the rest goes
};

}  // namespace blockweir::solid::output
