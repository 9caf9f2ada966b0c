// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of a small island whose states run in circles: gaps and slips at the end of the step are linear in the
// forces of its contacts, and Coulomb's law makes of that a complementarity problem (Stewart and Trinkle 1996, Int. J.
// Numer. Meth. Engng 39), which pivoting solves. Blocks turn: so again from where that has taken them.
#pragma once

#include <vector>

#include "solid/contact/coulomb_forces.hpp"
#include "solid/step/island_equations.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

class Pivoting : StepPart {
 public:
  explicit Pivoting(StepWorkspace& step) : StepPart(step) {}

  /// False where pivoting finds no forces either.
  bool find(IslandEquations& island, const StepMode& mode);

 private:
  /// An island without the forces of its contacts.
  struct Released {
    std::vector<int> ids;  ///< of contacts that may close
    CoulombContacts contacts;
    Eigen::MatrixXd moves_by;  ///< what unit forces of theirs do to the unknowns
  };
  [[nodiscard]] bool fits(const IslandEquations& island, const StepMode& mode) const;
  bool release_contacts(IslandEquations& island, Released& released);
};

}  // namespace blockweir::solid
