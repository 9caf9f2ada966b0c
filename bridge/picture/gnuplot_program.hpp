// SPDX-License-Identifier: GPL-3.0-or-later
// The gnuplot program, which reads commands and draws into files in memory.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::picture {

/// A file without a place, which vanishes with us.
class MemoryFile {
 public:
  /// Throws std::runtime_error where memory is short.
  MemoryFile();
  ~MemoryFile();
  MemoryFile(MemoryFile&& other) noexcept;
  MemoryFile& operator=(MemoryFile&&) = delete;
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int number() const { return file_; }
  /// What a child that inherits it opens.
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }
  [[nodiscard]] std::string text() const;

 private:
  int file_;
};

class GnuplotProgram {
 public:
  /// Draws into `outputs`. Throws std::runtime_error where no program can be started.
  explicit GnuplotProgram(const std::vector<MemoryFile>& outputs);
  ~GnuplotProgram();
  GnuplotProgram(const GnuplotProgram&) = delete;
  GnuplotProgram& operator=(const GnuplotProgram&) = delete;

  /// It draws while it reads: this takes as long. What it does not take shows when it ends.
  void read(std::string_view script);
  /// Throws std::runtime_error with gnuplot's last words where it is missing, or has refused a command.
  void end();

 private:
  MemoryFile words_;
  int line_ = -1;
  pid_t child_ = -1;
};

}  // namespace blockweir::picture
