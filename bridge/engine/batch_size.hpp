// SPDX-License-Identifier: GPL-3.0-or-later
// The number of items for a task of a queue: as many as take about ten minutes, judged by earlier tasks.
#pragma once

#include <cstddef>

namespace blockweir::engine {

/// What the finished tasks took.
struct Measured {
  std::size_t items = 0;
  double worked_s = 0;  ///< on the items, summed over processors
  int processors = 1;   ///< of a task

  /// Seconds for one item.
  [[nodiscard]] double each_s() const { return items == 0 ? 0 : worked_s / static_cast<double>(items) / processors; }
};

/// Items sent first, one each task, to measure how long one takes.
constexpr std::size_t first_items = 8;

/// Items for a task, at least 1, with `items` left to do. `measured` has at least one item.
std::size_t batch_size(std::size_t items, const Measured& measured);

}  // namespace blockweir::engine
