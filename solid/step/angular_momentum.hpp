// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of a step by Shi's scheme act on blocks where the step ends. About a common point they pull two blocks with
// different arms, as the blocks have moved meanwhile: what two give each other then turns them by
// dt (d_j - d_i)/2 x F, d their ways in the step. Blocks that nothing anchors get that angular momentum back.
#pragma once

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class AngularMomentum : StepPart {
 public:
  explicit AngularMomentum(StepWorkspace& step) : StepPart(step) {}

  /// Of each group of an island's touching blocks that nothing anchors: by a rigid turn of all, which no contact
  /// resists. After velocities have been found.
  void restore(IslandEquations& island);

 private:
  [[nodiscard]] double lost(const Interaction& action) const;
  [[nodiscard]] Point way(int block, const Point& material) const;
};

}  // namespace blockweir::solid
