// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/gnuplot.hpp"

#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <stdexcept>

namespace blockweir::launch {

void gnuplot(const std::string& script) {
  std::signal(SIGPIPE, SIG_IGN);  // a missing program shows in its exit status
  std::FILE* pipe = ::popen("gnuplot", "w");
  if (pipe == nullptr) throw std::runtime_error("cannot start gnuplot");
  std::fwrite(script.data(), 1, script.size(), pipe);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
    throw std::runtime_error("the program gnuplot is missing: install the package gnuplot-nox");
  }
  if (status != 0) throw std::runtime_error("gnuplot could not draw the figure: is the folder writable?");
}

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '_' || c == '^' || c == '{' || c == '}' || c == '@' || c == '&') quoted += "\\\\";
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "\"";
}

}  // namespace blockweir::launch
