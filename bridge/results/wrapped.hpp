// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as a terminal shows them.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace blockweir::results {

/// Each line of `text` broken between words where it is longer than `width`; what goes on is indented by eight. A word
/// that is longer stays whole.
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

/// As standard output shows it: wrapped on a terminal, else as it is, for programs that read lines.
inline std::string for_stdout(const std::string& text) {
  return ::isatty(STDOUT_FILENO) != 0 ? wrapped(text) : text;
}

/// The same for standard error: errors, warnings, lines of progress.
inline std::string for_stderr(const std::string& text) {
  return ::isatty(STDERR_FILENO) != 0 ? wrapped(text) : text;
}

}  // namespace blockweir::results
