// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the gnuplot program, which reads a script and draws into files in memory.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::picture {

/// A file in memory, without a name; it vanishes with this process.
class MemoryFile {
 public:
  /// Throws std::runtime_error if memory is short.
  MemoryFile();
  ~MemoryFile();
  MemoryFile(MemoryFile&& other) noexcept;
  MemoryFile& operator=(MemoryFile&&) = delete;
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] int number() const { return file_; }
  /// The path under which a child process that inherits it can open it.
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }
  [[nodiscard]] std::string text() const;
  /// Throws std::runtime_error if memory is short.
  void write(std::string_view text);

 private:
  int file_;
};

class GnuplotProgram {
 public:
  /// Starts drawing into `outputs`. Throws std::runtime_error if the program cannot be started.
  GnuplotProgram(const std::string& script, const std::vector<MemoryFile>& outputs);
  ~GnuplotProgram();
  GnuplotProgram(const GnuplotProgram&) = delete;
  GnuplotProgram& operator=(const GnuplotProgram&) = delete;

  /// Waits for the next printed line; false if there are no more.
  bool printed();
  /// Throws std::runtime_error with gnuplot's last message if it is missing or has refused a command.
  void end();

 private:
  MemoryFile script_;
  MemoryFile words_;
  int lines_ = -1;
  pid_t child_ = -1;
};

}  // namespace blockweir::picture
