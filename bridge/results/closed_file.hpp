// SPDX-License-Identifier: GPL-3.0-or-later
// A text file whose middle grows between a fixed head and tail; it is complete at any time.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::results {

class ClosedFile {
 public:
  ClosedFile(std::filesystem::path path, std::string head, std::string tail);
  ~ClosedFile();
  ClosedFile(const ClosedFile&) = delete;
  ClosedFile& operator=(const ClosedFile&) = delete;

  /// The first call replaces the file. In later calls `middle` must have grown only; the new part is written in one
  /// operation together with the tail, since replacing a file may take milliseconds. Throws std::runtime_error if the
  /// disk is full; the file is then as before.
  void put(const std::string& middle);

 private:
  std::filesystem::path path_;
  std::string head_;
  std::string tail_;
  int file_ = -1;
  std::size_t written_ = 0;  ///< of the middle
};

}  // namespace blockweir::results
