// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of a small island whose contact states cycle. Gaps and slips at the end of the step are linear in the
// contact forces, so that Coulomb's law gives a complementarity problem (Stewart and Trinkle 1996, Int. J. Numer. Meth.
// Engng 39), which pivoting solves. Since blocks rotate, this is repeated at the new positions.
#pragma once

#include <vector>

#include "solid/contact/coulomb_forces.hpp"
#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

class Pivoting : StepPart {
 public:
  explicit Pivoting(StepWorkspace& step) : StepPart(step) {}

  /// False if pivoting finds no forces either.
  bool find(IslandEquations& island, const StepMode& mode);

 private:
  /// An island without its contact forces.
  struct Released {
    std::vector<int> ids;  ///< contacts that may close
    CoulombContacts contacts;
    Eigen::MatrixXd moves_by;  ///< displacements by unit contact forces
  };
  [[nodiscard]] bool fits(const IslandEquations& island, const StepMode& mode) const;
  bool release_contacts(IslandEquations& island, Released& released);
};

}  // namespace blockweir::solid
