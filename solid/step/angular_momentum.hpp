// SPDX-License-Identifier: GPL-3.0-or-later
// Corrects angular momentum after a step of Shi's scheme. Its forces act on the blocks' final positions, so that a pair
// of contact forces has different arms about a common point and turns the two blocks by dt (d_j - d_i)/2 x F, d their
// displacements in the step. Free groups of blocks get this angular momentum back.
#pragma once

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class AngularMomentum : StepPart {
 public:
  explicit AngularMomentum(StepWorkspace& step) : StepPart(step) {}

  /// For each free group of touching blocks of an island: by a rigid rotation of the group, which no contact resists.
  /// Call after velocities are known.
  void restore(IslandEquations& island);

 private:
  [[nodiscard]] double lost(const Interaction& action) const;
  [[nodiscard]] Point way(int block, const Point& material) const;
};

}  // namespace blockweir::solid
