// SPDX-License-Identifier: GPL-3.0-or-later
// A text file that grows by whole lines and says so when it cannot.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace blockweir::results {

class ResultFile {
 public:
  /// Throws std::runtime_error when the file cannot be written.
  explicit ResultFile(std::filesystem::path path);

  /// Adds a line and hands it to the system, so that a killed run leaves whole lines. Throws std::runtime_error when
  /// the disk takes no more.
  void line(const std::string& text);

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
};

/// Puts `text` in place of the file in one go: a reader sees the old one or the new one. Throws std::runtime_error
/// and leaves the old one when that fails.
void replace_file(const std::filesystem::path& path, const std::string& text);

/// Throws the error that says so.
[[noreturn]] void cannot_write(const std::filesystem::path& path);

}  // namespace blockweir::results
