// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/touching_groups.hpp"

#include <algorithm>
#include <numeric>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

bool touches(const StepWorkspace& step, int contact) {
  return step.state.contacts[at(contact)].state != ContactState::open ||
         step.formulation->before().contact(contact).state != ContactState::open;
}

std::vector<int> touching_groups(const StepWorkspace& step, const IslandEquations& s) {
  std::vector<int> lower(s.island.blocks.size());
  std::iota(lower.begin(), lower.end(), 0);
  const auto lowest = [&](int k) {
    while (lower[at(k)] != k) k = lower[at(k)] = lower[at(lower[at(k)])];
    return k;
  };
  const auto join = [&](int a, int b) {
    if (!step.trial.moves(a) || !step.trial.moves(b)) return;
    const int i = lowest(s.local(a));
    const int j = lowest(s.local(b));
    lower[at(std::max(i, j))] = std::min(i, j);
  };
  for (const int k : s.island.contacts) {
    if (touches(step, k)) join(step.state.contacts[at(k)].vertex_part, step.state.contacts[at(k)].edge_part);
  }
  for (const int k : s.bolts) join(step.state.bolts[at(k)].part[0], step.state.bolts[at(k)].part[1]);
  for (const int k : s.couplings) join(step.model.parts.couplings[at(k)].i, step.model.parts.couplings[at(k)].j);
  for (int k = 0; k < static_cast<int>(lower.size()); ++k) lower[at(k)] = lowest(k);
  return lower;
}

Eigen::Matrix<double, 6, 3> rigid_motions(const Block& block, const Placement& placement, const Point& about) {
  Eigen::Matrix<double, 6, 3> motions = Eigen::Matrix<double, 6, 3>::Zero();
  const auto place = [&](Eigen::Index row, const Point& p) {
    motions.block<2, 2>(row, 0).setIdentity();
    motions.block<2, 1>(row, 2) = perpendicular(p - about);
  };
  if (block.is_part()) {
    for (int i = 0; i < 3; ++i) place(2 * i, placement.position(block.vertices[at(i)]));
  } else {
    place(0, placement.centre());
    motions(2, 2) = 1;
  }
  return motions;
}

}  // namespace blockweir::solid
