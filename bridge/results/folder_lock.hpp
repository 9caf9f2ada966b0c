// SPDX-License-Identifier: GPL-3.0-or-later
// One run at a time writes to a folder.
#pragma once

#include <filesystem>

namespace blockweir::results {

class FolderLock {
 public:
  /// Of a folder that exists, for as long as this lives or a child of this process that it has started meanwhile. A
  /// process that is killed lets go of it. Throws std::invalid_argument, with one line that names folder and process,
  /// where another process has it; that a launcher has it for us is well.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// The file in the folder that holds it, and the number of the process that took it; it stays there.
  static constexpr const char* file = ".lock";

 private:
  int descriptor_ = -1;
};

}  // namespace blockweir::results
