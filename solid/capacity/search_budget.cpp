// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/search_budget.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "bridge/results/seconds.hpp"

namespace blockweir::solid {

void SearchBudget::solved_one() {
  constexpr double longest_s = 600;
  constexpr double between_lines_s = 2;
  ++solved_;
  const double work_s = static_cast<double>(std::clock() - began_) / CLOCKS_PER_SEC;
  if (work_s > longest_s) {
    throw TookTooLong(fmt::format("{}: stopped after {:.0f} s of processor time, {}", whose_, work_s, known_));
  }
  if (solved_ > last_allowed_) throw Undecided(whose_ + ": one analysis took too long");
  if (seconds_since(told_) < between_lines_s) return;
  told_ = Clock::now();
  fmt::print(stderr, "{}: {}, {:.0f} s of processor time, {} linear systems solved\n", whose_, known_, work_s, solved_);
  std::fflush(stderr);
}

}  // namespace blockweir::solid
