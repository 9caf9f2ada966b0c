// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of an island's contacts and supports as unknowns beside the displacements of its blocks (Lagrange
// multipliers).
#pragma once

#include <vector>

#include "solid/contact/interaction.hpp"
#include "solid/solve/saddle_point.hpp"
#include "solid/step/step_workspace.hpp"

namespace blockweir::solid {

class IslandEquations;
class WaterInertia;

class UnknownForces : StepPart {
 public:
  /// The unknowns of the blocks must outlive it.
  UnknownForces(StepWorkspace& step, const Unknowns& unknowns) : StepPart(step), saddle_(unknowns) {}

  /// By the island's actions at the trial; none where the formulation solves for no forces.
  void set(const IslandEquations& island, const WaterInertia& water);
  [[nodiscard]] bool any() const { return !unknown_.empty(); }
  /// Corrects the forces, and finds the correction of the displacements; false where there is none.
  bool solve(IslandEquations& island);
  [[nodiscard]] Eigen::MatrixXd dense() const { return saddle_.dense(); }

 private:
  /// Of a contact or a support: what a unit of it exerts (normal, shear).
  struct UnknownForce {
    bool support;
    int index;
    Eigen::Vector2d force;
  };

  void add(const IslandEquations& island, const Interaction& action, bool support, int index);
  void correct(const IslandEquations& island);

  SaddlePoint saddle_;
  std::vector<UnknownForce> unknown_;
  Eigen::VectorXd forces_;
};

}  // namespace blockweir::solid
