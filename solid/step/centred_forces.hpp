// SPDX-License-Identifier: GPL-3.0-or-later
// Forces by which many rigid blocks that rest go on resting, in contacts without bonds or with bonds that last. Of all
// admissible forces those farthest from their bounds: their analytic centre (Sonnevend 1985), which maximizes the
// product of the distances from all bounds. Newton's method follows it from the forces of the step before in a solution
// or two; where there are none, a primal-dual method finds it. The contact states need no search meanwhile: at the
// centre every contact sticks.
#pragma once

#include <vector>

#include "solid/step/bounded_force.hpp"
#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

/// Whether admissible forces hold blocks where they are.
enum class Held { yes, no, unknown };

class CentredForces : StepPart {
 public:
  explicit CentredForces(StepWorkspace& step) : StepPart(step) {}

  /// Is it an island of many rigid blocks that such forces could hold? Not in steps that settle, and not where forces
  /// are not those of hard contacts.
  [[nodiscard]] bool suits(const IslandEquations& island, const StepMode& mode) const;
  /// And so slow that it may rest?
  [[nodiscard]] bool may_hold(const IslandEquations& island, const StepMode& mode) const;

  /// Do such forces hold the island where the step began? They act then. Otherwise the trial and its contacts are left
  /// as they come.
  Held hold(IslandEquations& island);

 private:
  struct Fractions {
    double of_forces = 1;
    double of_motions = 1;
  };

  bool begin(IslandEquations& island);
  double unbalanced(IslandEquations& island);
  bool find_changes(IslandEquations& island);
  void set_stiffnesses(IslandEquations& island);
  void find_residual_at_rest(IslandEquations& island, double product);
  void set_changes(const IslandEquations& island, double product);
  [[nodiscard]] bool none_can_hold(const IslandEquations& island) const;
  [[nodiscard]] Fractions fractions(double within) const;
  [[nodiscard]] double mean_product(double of_forces, double of_motions) const;
  void change();
  void take(IslandEquations& island);

  std::vector<BoundedForce> forces_;  ///< of the island's contacts
  Eigen::VectorXd loads_;
  double share_ = 0;    ///< of the stiffnesses: large against inertia
  bool whole_ = false;  ///< were the last changes made as found? At first: are there forces of a step before?
};

}  // namespace blockweir::solid
