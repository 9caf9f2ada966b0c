// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/sleep.hpp"

#include <algorithm>

#include "solid/block/parallel.hpp"

namespace blockweir::solid {

void Sleep::look(const std::vector<Block>& blocks, const std::vector<Vector6>& increments,
                 const std::vector<Vector6>& external, double dt) {
  const double still_m = 1e-12 * size_;
  const double held_m = std::min(still_m, 1e-7 * 9.81 * dt * dt / 2);
  for_each(blocks.size(), [&](std::size_t b) {
    const double moved_m = std::max(increments[b].head<2>().cwiseAbs().maxCoeff(),
                                    blocks[b].radius * increments[b].tail<4>().cwiseAbs().maxCoeff());
    const bool rests = moved_m <= (blocks[b].fixed ? still_m : held_m);
    if (!rests) {
      rests_[b] = 0;
    } else if (++rests_[b] == long_enough) {
      load_[b] = external[b];
    }
  });
}

bool Sleep::rests(std::size_t b, const std::vector<Block>& blocks, const std::vector<Vector6>& external,
                  double tolerance_n) const {
  if (rests_[b] < long_enough) return false;
  if (blocks[b].fixed) return true;
  const Vector6 change = external[b] - load_[b];
  return std::max(change.head<2>().cwiseAbs().maxCoeff(), change.tail<4>().cwiseAbs().maxCoeff() / blocks[b].radius) <=
         tolerance_n;
}

}  // namespace blockweir::solid
