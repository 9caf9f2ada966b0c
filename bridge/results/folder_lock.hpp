// SPDX-License-Identifier: GPL-3.0-or-later
// A lock: only one run at a time writes to a folder.
#pragma once

#include <filesystem>

namespace blockweir::results {

class FolderLock {
 public:
  /// Locks an existing folder for the lifetime of this object, and of child processes started meanwhile. The lock of a
  /// killed process ends. Throws std::invalid_argument, with one line that names folder and process, if another process
  /// holds it; a lock that our launcher holds for us is accepted, and one that we hold already.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// The lock file in the folder, with the number of the process that holds the lock; the file stays.
  static constexpr const char* file = ".lock";

  /// Throws std::invalid_argument, with one line for the user, if another process writes to `folder`: for one who
  /// reads.
  static void refuse_in_use(const std::filesystem::path& folder);

 private:
  int descriptor_ = -1;
};

}  // namespace blockweir::results
