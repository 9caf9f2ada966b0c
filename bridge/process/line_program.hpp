// SPDX-License-Identifier: GPL-3.0-or-later
// A program of ours that reads requests line by line and answers each on its standard output.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blockweir::process {

class LineProgram {
 public:
  /// `words`: the program's name, in the folder of this program, and its arguments. Throws std::runtime_error if it
  /// cannot be started.
  explicit LineProgram(std::vector<std::string> words);
  /// Closes its input, which ends it.
  ~LineProgram();
  LineProgram(const LineProgram&) = delete;
  LineProgram& operator=(const LineProgram&) = delete;

  void say(const nlohmann::json& line);
  /// Reads its next line. Throws std::runtime_error with its last message if it has ended.
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
