// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene of many blocks has come to.
#pragma once

#include <algorithm>
#include <cmath>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

inline void run_steps(Solid& solid, int steps) {
  const double dt = solid.scene().analysis.step_s;
  for (int n = 0; n < steps; ++n) solid.advance(n * dt, (n + 1) * dt, {});
}

/// Contact forces upward on the ground, block 0, over the weight of all that rests on it, less 1.
inline double reaction_error(const Solid& solid) {
  double weight = 0;
  for (const Block& block : solid.blocks()) weight += block.fixed ? 0 : block.mass_per_m() * 9.81;
  double reaction = 0;
  for (const ContactPoint& c : solid.contacts()) {
    if (c.state != ContactState::open && (c.vertex_block == 0 || c.edge_block == 0)) reaction += c.force.x();
  }
  return reaction / weight - 1;
}

/// Shear beyond what the normal force allows, or a pull, at any contact, over the weight of all [1].
inline double worst_against_coulomb(const Solid& solid, double friction) {
  double weight = 0;
  for (const Block& block : solid.blocks()) weight += block.fixed ? 0 : block.mass_per_m() * 9.81;
  double worst = 0;
  for (const ContactPoint& c : solid.contacts()) {
    if (c.state == ContactState::open) continue;
    worst = std::max({worst, -c.force.x(), std::abs(c.force.y()) - friction * c.force.x()});
  }
  return worst / weight;
}

}  // namespace blockweir::solid
