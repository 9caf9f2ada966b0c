// SPDX-License-Identifier: GPL-3.0-or-later
// A private folder, gone with its object.
#pragma once

#include <filesystem>

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
};

}  // namespace blockweir::process
