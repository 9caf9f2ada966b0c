// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium by sweeps over the contacts, for islands whose contact states Newton's method does not find. Their number
// is bounded; whenever they stop, forces are admissible and momentum balances.
#pragma once

#include "solid/step/centred_forces.hpp"
#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"
#include "solid/step/sweep_rows.hpp"

namespace blockweir::solid {

class SweptEquilibrium : StepPart {
 public:
  /// `held`: what is known of forces by which nothing moves.
  explicit SweptEquilibrium(StepWorkspace& step, Held held = Held::unknown) : StepPart(step), held_(held) {}

  /// By sweeps, or by Newton's method started from their result.
  Found find(IslandEquations& island, const StepMode& mode);

 private:
  bool fly(IslandEquations& island);
  [[nodiscard]] double most_of(const IslandEquations& island) const;
  double sweep(IslandEquations& island, int most, double enough_m);
  [[nodiscard]] bool turns_too_far(const IslandEquations& island) const;
  bool finish(IslandEquations& island, const StepMode& mode);
  void begin(IslandEquations& island);
  void start_again(const IslandEquations& island);
  void add_contacts(IslandEquations& island, SweepRows& rows, bool first_round);
  bool linearize(IslandEquations& island, SweepRows& rows, bool first_round);
  [[nodiscard]] bool pumps(const IslandEquations& island) const;
  [[nodiscard]] bool is_dry(const IslandEquations& island) const;
  void stand_or_go(IslandEquations& island);
  bool stand(IslandEquations& island, const std::vector<Matrix6>& matrix);
  void go(IslandEquations& island, const std::vector<Matrix6>& matrix);
  template <class Forces>
  void take(IslandEquations& island, const Forces& forces);
  void take_forces(IslandEquations& island);

  Held held_;
  double moves_m_ = 0;  ///< in the step, at the velocity of its start: the slower, the more sweeps it is worth
};

}  // namespace blockweir::solid
