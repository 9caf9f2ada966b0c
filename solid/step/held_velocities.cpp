// SPDX-License-Identifier: GPL-3.0-or-later
// Shi's scheme turns a velocity that is held into its opposite, undamped: such velocities are put right after the step.
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Velocities along held directions (closed contacts, sticking ones along the edge too, supports) become the mean of
/// the step: the velocities get the smallest change, in the metric of the step's matrix, that does so. Friction of a
/// slipping contact has no part in it: with that coupling the projection could grow what it should remove.
void Solid::quiet_held_directions(IslandSystem& s, double dt) {
  constexpr double unheard_m_per_s = 1e-9;
  const auto rests = [this](int b) { return increment_[at(b)].isZero(0) && states_[at(b)].velocity.isZero(0); };
  if (!base_.moves_supports() && std::all_of(s.island.blocks.begin(), s.island.blocks.end(), rests)) return;
  double loudest = 0;
  const auto mismatch = [&](const Interaction& a, bool second) -> Eigen::Vector2d {
    if (a.block(second) < 0) return Eigen::Vector2d::Zero();
    const auto b = at(a.block(second));
    return a.shape(placement_[b], second) * (increment_[b] / dt - rate(b, placement_[b], states_[b].velocity));
  };
  std::vector<Interaction>& actions = s.actions;
  std::vector<Eigen::Vector2d> pull(actions.size(), Eigen::Vector2d::Zero());
  for (std::size_t k = 0; k < actions.size(); ++k) {
    const Interaction& a = actions[k];
    if (a.held.isZero(0)) continue;
    const Eigen::Vector2d m = mismatch(a, false) - mismatch(a, true);
    pull[k] = a.held_stiffness() * m;
    const Eigen::Vector2d along(m.x() + a.held_slope() * m.y(), m.y());
    for (int axis = 0; axis < 2; ++axis) {
      if (a.held[axis] > 0) loudest = std::max(loudest, std::abs(along[axis]));
    }
  }
  if (loudest <= unheard_m_per_s) return;

  set_block_matrices(s);
  s.residual.setZero();
  for (std::size_t k = 0; k < actions.size(); ++k) {
    Interaction& a = actions[k];
    a.stiffness = a.held_stiffness();
    add_stiffness(*s.system, a);
    a.force = pull[k];
    for (const bool second : {false, true}) {
      if (!moves(a.block(second))) continue;
      const auto b = at(a.block(second));
      const Vector6 push = placement_[b].generalized((second ? -1 : 1) * a.pull(), a.at(second));
      s.unknowns->add(local_[b], push, s.residual);
    }
  }
  if (!solve(s, /*symmetric=*/true)) return;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    states_[at(s.island.blocks[k])].velocity += s.unknowns->take_own(static_cast<int>(k), s.correction);
  }
}

}  // namespace blockweir::solid
