// SPDX-License-Identifier: GPL-3.0-or-later
// A private folder, gone with its object, or when the next one is made after its process was killed.
#pragma once

#include <filesystem>
#include <optional>

#include "bridge/results/folder_lock.hpp"

namespace blockweir::process {

class TemporaryFolder {
 public:
  /// Throws std::runtime_error when none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::optional<results::FolderLock> lock_;  ///< tells the folders of the living from those of the dead
};

}  // namespace blockweir::process
