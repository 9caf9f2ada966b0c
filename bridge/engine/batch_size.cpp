// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/engine/batch_size.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::engine {

std::size_t batch_size(std::size_t items, const Measured& measured) {
  constexpr double task_s = 600;
  constexpr std::size_t most_tasks = 1000;  // Slurm's MaxArraySize is 1001 by default
  const std::size_t least = std::max<std::size_t>(1, (items + most_tasks - 1) / most_tasks);
  const double fit = measured.each_s() > 0 ? std::floor(task_s / measured.each_s()) : static_cast<double>(items);
  return fit >= static_cast<double>(items) ? std::max(items, least) : std::max(static_cast<std::size_t>(fit), least);
}

}  // namespace blockweir::engine
