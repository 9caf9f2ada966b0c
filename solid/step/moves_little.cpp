// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/moves_little.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

bool moves_little(const StepWorkspace& step, const IslandEquations& island) {
  const double still_m = 10 * enough_share * step.trial.fall_m();
  return std::all_of(island.island.blocks.begin(), island.island.blocks.end(), [&](int block) {
    const Vector6& velocity = step.state.blocks[at(block)].velocity;
    const double turning = velocity.tail<4>().cwiseAbs().sum() * step.model.blocks[at(block)].radius;
    return (velocity.head<2>().norm() + turning) * step.trial.dt <= still_m;
  });
}

}  // namespace blockweir::solid
