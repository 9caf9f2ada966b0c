// SPDX-License-Identifier: GPL-3.0-or-later
// A program of ours that is asked line by line, and answers each on its standard output.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blockweir::process {

class LineProgram {
 public:
  /// `words`: the program's name, which stands beside this one, and its arguments. Throws std::runtime_error where it
  /// cannot be started.
  explicit LineProgram(std::vector<std::string> words);
  /// It ends as it reads no more.
  ~LineProgram();
  LineProgram(const LineProgram&) = delete;
  LineProgram& operator=(const LineProgram&) = delete;

  void say(const nlohmann::json& line);
  /// Its next line. Throws std::runtime_error with its last words where it has ended.
  nlohmann::json hear();
  nlohmann::json ask(const nlohmann::json& line) {
    say(line);
    return hear();
  }

 private:
  [[noreturn]] void has_ended();

  std::string name_;
  pid_t child_ = -1;
  int line_ = -1;
  int log_ = -1;
  std::string heard_;
};

}  // namespace blockweir::process
