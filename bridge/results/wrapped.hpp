// SPDX-License-Identifier: GPL-3.0-or-later
// Wraps lines for a terminal.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace blockweir::results {

/// Breaks each line of `text` that is longer than `width` between words; continuation lines are indented by eight.
/// Longer words stay whole.
inline std::string wrapped(const std::string& text, std::size_t width = 80) {
  constexpr std::size_t indent = 8;
  std::string all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (line.size() > width) {
      auto at = line.rfind(' ', width);
      if (at == std::string::npos || at <= indent) at = line.find(' ', std::max(width, indent + 1));
      if (at == std::string::npos) break;
      all += line.substr(0, at) + "\n";
      line = std::string(indent, ' ') + line.substr(at + 1);
    }
    all += line + "\n";
  }
  return all;
}

/// For standard output: wrapped on a terminal, otherwise unchanged, for programs that read lines.
inline std::string for_stdout(const std::string& text) {
  return ::isatty(STDOUT_FILENO) != 0 ? wrapped(text) : text;
}

/// The same for standard error: errors, warnings, lines of progress.
inline std::string for_stderr(const std::string& text) {
  return ::isatty(STDERR_FILENO) != 0 ? wrapped(text) : text;
}

}  // namespace blockweir::results
