// SPDX-License-Identifier: GPL-3.0-or-later
// A text file whose middle grows between a head and a tail, whole whenever somebody looks.
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

  /// The first time puts a file with this middle in place of what was there. Later `middle` has only grown, and what is
  /// new goes out in one write with the tail behind it: a file system may take milliseconds to put a file in another's
  /// place. Throws std::runtime_error when the disk takes no more; the file is then as it was before.
  void put(const std::string& middle);

 private:
  std::filesystem::path path_;
  std::string head_;
  std::string tail_;
  int file_ = -1;
  std::size_t written_ = 0;  ///< of the middle
};

}  // namespace blockweir::results
