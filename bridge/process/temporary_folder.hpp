// SPDX-License-Identifier: GPL-3.0-or-later
// A private temporary folder, removed with its object; if the process was killed, the next object removes it.
#pragma once

#include <filesystem>
#include <optional>

#include "bridge/results/folder_lock.hpp"

namespace blockweir::process {

class TemporaryFolder {
 public:
  /// Throws std::runtime_error if none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::optional<results::FolderLock> lock_;  ///< marks the folders of live processes
};

}  // namespace blockweir::process
