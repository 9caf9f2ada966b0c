// SPDX-License-Identifier: GPL-3.0-or-later
// How many items a task of a queue gets: as many as take some ten minutes, by what those before took.
#pragma once

#include <cstddef>

namespace blockweir::engine {

/// What tasks that have come to their end took.
struct Measured {
  std::size_t items = 0;
  double worked_s = 0;  ///< on them, summed over processors
  int processors = 1;   ///< of a task

  /// That one takes a task.
  [[nodiscard]] double each_s() const { return items == 0 ? 0 : worked_s / static_cast<double>(items) / processors; }
};

/// Items that are sent first, each as a task of its own, to see how long one takes.
constexpr std::size_t first_items = 8;

/// Of `items` still to do, in a task; at least 1. `measured` has one at least.
std::size_t batch_size(std::size_t items, const Measured& measured);

}  // namespace blockweir::engine
