// SPDX-License-Identifier: GPL-3.0-or-later
// Contact and support forces of an island as unknowns besides the displacements of its blocks (Lagrange
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
  /// `unknowns` must outlive the object.
  UnknownForces(StepWorkspace& step, const Unknowns& unknowns) : StepPart(step), saddle_(unknowns) {}

  /// From the island's actions at the trial positions; none if the formulation has no unknown forces.
  void set(const IslandEquations& island, const WaterInertia& water);
  [[nodiscard]] bool any() const { return !unknown_.empty(); }
  /// Corrects the forces and solves for the correction of the displacements; false if there is no solution.
  bool solve(IslandEquations& island);
  [[nodiscard]] Eigen::MatrixXd dense() const { return saddle_.dense(); }

 private:
  /// For a contact or support: the effect of a unit force (normal, shear).
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
