// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/effort.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "bridge/results/seconds.hpp"

namespace blockweir::solid {

void Effort::solved_one() {
  constexpr double longest_s = 600;
  constexpr double between_lines_s = 2;
  ++solved_;
  const auto now = Clock::now();
  const double so_far_s = seconds_between(began_, now);
  if (so_far_s > longest_s) throw TookTooLong(fmt::format("{}: stopped after {:.0f} s, {}", whose_, so_far_s, known_));
  if (seconds_between(told_, now) < between_lines_s) return;
  told_ = now;
  fmt::print(stderr, "{}: {}, {:.0f} s, {} linear systems solved\n", whose_, known_, so_far_s, solved_);
  std::fflush(stderr);
}

}  // namespace blockweir::solid
