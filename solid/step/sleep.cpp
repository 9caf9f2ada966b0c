// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/sleep.hpp"

#include <algorithm>

#include "solid/block/parallel.hpp"

namespace blockweir::solid {

void Sleep::look(const std::vector<Block>& blocks, const std::vector<BlockState>& states,
                 const std::vector<Vector6>& external, double dt) {
  constexpr double still = 1e-12;
  constexpr double inertia_m_per_s2 = 1e-7 * 9.81;
  for_each(blocks.size(), [&](std::size_t b) {
    const auto fastest = [&](const Vector6& rate) {
      if (blocks[b].is_part()) return rate.cwiseAbs().maxCoeff();  // of its corners
      return std::max(rate.head<2>().cwiseAbs().maxCoeff(), blocks[b].radius * rate.tail<4>().cwiseAbs().maxCoeff());
    };
    const bool rests = dt * fastest(states[b].velocity) <= still * size_ &&
                       (blocks[b].fixed || fastest(states[b].acceleration) <= inertia_m_per_s2);
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
