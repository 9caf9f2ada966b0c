// SPDX-License-Identifier: GPL-3.0-or-later
// The gnuplot program, which reads a script and draws into files in memory.
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
  /// Throws std::runtime_error where memory is short.
  void write(std::string_view text);

 private:
  int file_;
};

class GnuplotProgram {
 public:
  /// Begins to draw into `outputs`. Throws std::runtime_error where no program can be started.
  GnuplotProgram(const std::string& script, const std::vector<MemoryFile>& outputs);
  ~GnuplotProgram();
  GnuplotProgram(const GnuplotProgram&) = delete;
  GnuplotProgram& operator=(const GnuplotProgram&) = delete;

  /// Waits until it prints a line; false where it prints no more.
  bool printed();
  /// Throws std::runtime_error with gnuplot's last words where it is missing, or has refused a command.
  void end();

 private:
  MemoryFile script_;
  MemoryFile words_;
  int lines_ = -1;
  pid_t child_ = -1;
};

}  // namespace blockweir::picture
