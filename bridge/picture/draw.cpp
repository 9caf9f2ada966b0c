// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/draw.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "bridge/picture/gnuplot_program.hpp"
#include "bridge/picture/stop_message.hpp"
#include "bridge/results/result_file.hpp"

namespace blockweir::picture {

namespace {

class DrawnShare {
 public:
  explicit DrawnShare(bool shown) : shown_(shown), terminal_(::isatty(STDERR_FILENO) != 0) {}
  ~DrawnShare() {
    if (shown_ && terminal_) fmt::print(stderr, "\r\033[K");
  }
  DrawnShare(const DrawnShare&) = delete;
  DrawnShare& operator=(const DrawnShare&) = delete;
  void show(double share) {
    if (!shown_) return;
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
  bool shown_;
  bool terminal_;
  int tenths_ = 0;
};

std::string terminal_of(const Picture& picture) {
  const std::string ending = picture.file.extension().string();
  const std::string size = fmt::format("noenhanced size {:.0f},{:.0f}", picture.width, picture.height);
  if (ending == ".svg") return fmt::format("svg {} background 'white' font 'sans,{}'", size, picture.letter_points + 2);
  if (ending == ".gif") return fmt::format("gif animate delay 10 loop 0 {}", size);  // a tenth of a second each
  return fmt::format("pngcairo {} font 'sans,{}'", size, picture.letter_points);
}

}  // namespace

std::string gnuplot_script(const Picture& picture, const std::string& output) {
  return fmt::format("reset\nset terminal {}\nset output '{}'\n{}unset output\nundefine $*\n{}", terminal_of(picture),
                     output, picture.commands, one_more_drawn);
}

void draw(const std::vector<Picture>& pictures, bool show_progress) {
  const std::vector<MemoryFile> drawn(pictures.size());
  std::string script = "set print '-'\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) script += gnuplot_script(pictures[i], drawn[i].path());
  std::size_t all = 0;
  for (std::size_t at = 0; (at = script.find(one_more_drawn, at)) != std::string::npos; ++at) ++all;
  GnuplotProgram program(script, drawn);
  {
    DrawnShare share(show_progress);
    for (std::size_t done = 0; program.printed();) {
      share.show(static_cast<double>(++done) / static_cast<double>(std::max(all, done)));
    }
  }
  program.end();
  const TooLateToStop some_are_in_place;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string& file = pictures[i].file.string();
    const std::string picture = drawn[i].text();
    if (picture.empty()) throw std::runtime_error(file + ": gnuplot drew nothing; try again with more memory");
    results::replace_file(file, picture);
  }
}

}  // namespace blockweir::picture
