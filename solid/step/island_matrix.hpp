// SPDX-License-Identifier: GPL-3.0-or-later
// Contributions of an island's blocks and interactions to its matrix, for a linear system or a saddle point.
#pragma once

#include "solid/contact/interaction.hpp"
#include "solid/step/step_trial.hpp"

namespace blockweir::solid {

class IslandEquations;

class IslandMatrix {
 public:
  IslandMatrix(const Model& model, const StepTrial& trial, const IslandEquations& island)
      : model_(model), trial_(trial), s_(island) {}

  /// The blocks' own matrices on the diagonal, and couplings of mesh triangles off it.
  template <class System>
  void add_own(System& to) const;
  /// A contact, support or bolt adds J^T C J on the diagonal of each block, and -J^T C J between the two.
  template <class System>
  void add_stiffness(System& to, const Interaction& action) const {
    if (is_between_rigid(action)) return add_rigid_stiffness(to, action);
    add_columns(to, action, false);
    add_columns(to, action, true);
  }
  /// Adds to the columns of one of the two blocks.
  template <class System>
  void add_columns(System& to, const Interaction& action, bool of_second) const;

 private:
  [[nodiscard]] bool is_between_rigid(const Interaction& action) const;
  template <class System>
  void add_rigid_stiffness(System& to, const Interaction& action) const;

  const Model& model_;
  const StepTrial& trial_;
  const IslandEquations& s_;
};

}  // namespace blockweir::solid
