// SPDX-License-Identifier: GPL-3.0-or-later
// All integrators here turn a velocity that is held into its opposite, undamped: such velocities are settled after the
// step by what holds them.
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Velocities along held directions (closed contacts, sticking ones along the edge too, supports) become those of what
/// holds them; the velocities get the smallest change, in the metric of the step's matrix, that does so. Friction of a
/// slipping contact has no part in it: with that coupling the projection could grow what it should remove. Where the
/// scene's integrator is Shi's, of first order, they become the step's mean instead, which needs no rate of what leads.
void Solid::settle_held_velocities(IslandSystem& s, double dt) {
  constexpr double unheard_m_per_s = 1e-9;
  const auto rests = [this](int b) { return increment_[at(b)].isZero(0) && states_[at(b)].velocity.isZero(0); };
  if (!base_.moves_supports() && std::all_of(s.island.blocks.begin(), s.island.blocks.end(), rests)) return;
  const bool to_mean = scene_.analysis.integrator == scene::Integrator::shi || !newmark_.damps;
  const auto lacks = [&](const Interaction& a, bool second) -> Eigen::Vector2d {
    if (a.block(second) < 0) return Eigen::Vector2d::Zero();
    const auto b = at(a.block(second));
    const Vector6 mean = to_mean ? Vector6(increment_[b] / dt) : Vector6(Vector6::Zero());
    return a.shape(placement_[b], second) * (mean - rate(b, placement_[b], states_[b].velocity));
  };
  double loudest = 0;
  std::vector<Eigen::Vector2d> missing(s.actions.size(), Eigen::Vector2d::Zero());
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    const Interaction& a = s.actions[k];
    if (a.held.isZero(0)) continue;
    Eigen::Vector2d m = lacks(a, false) - lacks(a, true);
    if (!to_mean) m += led_rate(s, k, dt);
    missing[k] = a.held_stiffness(opening_slope(s, k)) * m;
    const Eigen::Vector2d along(m.x() - opening_slope(s, k) * m.y(), m.y());
    for (int axis = 0; axis < 2; ++axis) {
      if (a.held[axis] > 0) loudest = std::max(loudest, std::abs(along[axis]));
    }
  }
  if (loudest > unheard_m_per_s) project_held_velocities(s, missing);
}

/// Of a support by its table and the base; contacts are not led.
Eigen::Vector2d Solid::led_rate(const IslandSystem& s, std::size_t action, double dt) const {
  const std::size_t contacts = s.island.contacts.size();
  if (action < contacts) return Eigen::Vector2d::Zero();
  return supports_[at(s.island.supports[action - contacts])].target_rate(end_s_, dt) + base_.velocity(end_s_);
}

/// By how much a joint that dilates opens as it slips.
double Solid::opening_slope(const IslandSystem& s, std::size_t action) const {
  if (action >= s.island.contacts.size()) return 0;
  const int k = s.island.contacts[action];
  return formulation_->opening_slope(k, contacts_[at(k)]);
}

/// `missing`: of each action, weighted by what holds.
void Solid::project_held_velocities(IslandSystem& s, const std::vector<Eigen::Vector2d>& missing) {
  set_block_matrices(s);
  s.residual.setZero();
  for (std::size_t k = 0; k < s.actions.size(); ++k) {
    Interaction& a = s.actions[k];
    a.stiffness = a.held_stiffness(opening_slope(s, k));
    add_stiffness(*s.system, a);
    a.force = missing[k];
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
