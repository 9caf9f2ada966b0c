// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/gnuplot.hpp"

#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <stdexcept>

namespace blockweir::picture {

namespace {

class DrawnShare {
 public:
  explicit DrawnShare(bool told) : told_(told), terminal_(::isatty(STDERR_FILENO) != 0) {}
  ~DrawnShare() {
    if (told_ && terminal_) fmt::print(stderr, "\r\033[K");
  }
  DrawnShare(const DrawnShare&) = delete;
  DrawnShare& operator=(const DrawnShare&) = delete;
  void show(double share) {
    if (!told_) return;
    constexpr int width = 30;
    const int filled = static_cast<int>(share * width);
    if (terminal_) {
      fmt::print(stderr, "\r[{:=<{}}{: <{}}] {:3.0f} %  drawing\033[K", "", filled, "", width - filled, 100 * share);
    } else if (static_cast<int>(10 * share) > tenths_) {
      tenths_ = static_cast<int>(10 * share);
      fmt::print(stderr, "{:3.0f} %  drawing\n", 100 * share);
    }
    std::fflush(stderr);
  }

 private:
  bool told_;
  bool terminal_;
  int tenths_ = 0;
};

/// gnuplot draws while it reads: the pipe takes more as it gets on.
void write_told(const std::string& script, std::FILE* pipe, bool told) {
  constexpr std::size_t piece = 16384;
  DrawnShare drawn(told);
  for (std::size_t at = 0; at < script.size(); at += piece) {
    const std::size_t size = std::min(piece, script.size() - at);
    std::fwrite(script.data() + at, 1, size, pipe);
    std::fflush(pipe);
    drawn.show(static_cast<double>(at + size) / static_cast<double>(script.size()));
  }
}

}  // namespace

void gnuplot(const std::string& script, bool told) {
  std::signal(SIGPIPE, SIG_IGN);                          // a missing program shows in its exit status
  std::FILE* pipe = ::popen("gnuplot 2>/dev/null", "w");  // it warns of each curve that is level
  if (pipe == nullptr)
    throw std::runtime_error("cannot start gnuplot: the system opens no pipe to it; end other programs");
  write_told(script, pipe, told);
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
