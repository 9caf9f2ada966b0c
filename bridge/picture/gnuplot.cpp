// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/gnuplot.hpp"

#include <fmt/format.h>

#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <stdexcept>

namespace blockweir::picture {

void gnuplot(const std::string& script) {
  std::signal(SIGPIPE, SIG_IGN);                          // a missing program shows in its exit status
  std::FILE* pipe = ::popen("gnuplot 2>/dev/null", "w");  // it warns of each curve that is level
  if (pipe == nullptr)
    throw std::runtime_error("cannot start gnuplot: the system opens no pipe to it; end other programs");
  std::fwrite(script.data(), 1, script.size(), pipe);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
    throw std::runtime_error("the program gnuplot is missing: install the package gnuplot-nox");
  }
  if (status != 0) {
    throw std::runtime_error(
        fmt::format("gnuplot drew no figure: it ended with status {}; expected a folder that can be written, with room "
                    "for the figure; gnuplot's own message stands above",
                    status));
  }
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

std::string gnuplot_path(const std::filesystem::path& path) {
  std::string quoted = "'";
  for (const char c : path.string()) {
    if (c == '\'') quoted += '\'';
    quoted += c;
  }
  return quoted + "'";
}

std::string gnuplot_polygon(int number, const std::vector<Eigen::Vector2d>& outline, const std::string& style) {
  std::string text = fmt::format("set object {} polygon", number);
  for (std::size_t i = 0; i <= outline.size(); ++i) {
    const Eigen::Vector2d& p = outline[i % outline.size()];
    text += fmt::format(" {} {},{}", i == 0 ? "from" : "to", p.x(), p.y());
  }
  return text + " " + style + "\n";
}

}  // namespace blockweir::picture
