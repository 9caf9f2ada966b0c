// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace blockweir::process {
namespace {

/// 4,000
std::string grouped(long number) {
  std::string text = std::to_string(number);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

}  // namespace

Progress::Progress(int fd, double duration_s, bool quiet)
    : fd_(fd), duration_s_(duration_s), quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}

bool Progress::update() {
  char buffer[4096];
  for (ssize_t n = 0; (n = ::read(fd_, buffer, sizeof buffer)) > 0;)
    pending_.append(buffer, static_cast<std::size_t>(n));
  const auto end = pending_.rfind('\n');
  if (end == std::string::npos) return begun_;
  const auto previous = end == 0 ? std::string::npos : pending_.rfind('\n', end - 1);
  const std::string line = pending_.substr(previous == std::string::npos ? 0 : previous + 1, end);
  pending_.erase(0, end + 1);
  long solutions = 0;
  if (std::sscanf(line.c_str(), "settling %ld", &solutions) == 1) {
    show_solutions(fmt::format("settling: {} linear systems solved", grouped(solutions)), solutions);
    return begun_;
  }
  begun_ = true;
  double time_s = 0;
  double level_m = 0;
  double displacement_m = 0;
  unsigned long window = 0;
  if (std::sscanf(line.c_str(), "solving %lu %lf %ld", &window, &time_s, &solutions) == 3) {
    if (std::exchange(window_, window) != window) next_solutions_ = first_solutions;
    show_solutions(fmt::format("window {}, {:.4g} s: {} solutions so far", window, time_s, grouped(solutions)),
                   solutions);
    return begun_;
  }
  if (!quiet_ && std::sscanf(line.c_str(), "%lf %lf %lf", &time_s, &level_m, &displacement_m) == 3) {
    show(time_s, level_m, displacement_m);
  }
  return begun_;
}

void Progress::show_solutions(const std::string& words, long solutions) {
  if (quiet_) return;
  if (terminal_) {
    fmt::print(stderr, "\r{}\033[K", words);
  } else if (solutions >= next_solutions_) {
    while (next_solutions_ <= solutions) next_solutions_ *= 2;
    fmt::print(stderr, "{}\n", words);
  }
  std::fflush(stderr);
}

void Progress::show(double time_s, double level_m, double displacement_m) {
  const double done = std::clamp(time_s / duration_s_, 0.0, 1.0);
  const std::string level = std::isnan(level_m) ? "" : fmt::format("  level {:.3f} m", level_m);
  if (terminal_) {
    constexpr int width = 30;
    const int filled = static_cast<int>(done * width);
    fmt::print(stderr, "\r[{:=<{}}{: <{}}] {:3.0f} %  {:.2f} s{}  moved {:.3g} m\033[K", "", filled, "", width - filled,
               100 * done, time_s, level, displacement_m);
  } else if (static_cast<int>(10 * done) > shown_tenths_) {
    shown_tenths_ = static_cast<int>(10 * done);
    fmt::print(stderr, "{:3.0f} %  {:.2f} s{}  moved {:.3g} m\n", 100 * done, time_s, level, displacement_m);
  }
  std::fflush(stderr);
}

void Progress::finish() const {
  if (terminal_ && !quiet_) fmt::print(stderr, "\r\033[K");
}

}  // namespace blockweir::process
