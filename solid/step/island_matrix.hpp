// SPDX-License-Identifier: GPL-3.0-or-later
// What the blocks of an island, and what holds them, add to its matrix. A linear system or a saddle point takes it.
#pragma once

#include "solid/contact/interaction.hpp"
#include "solid/step/step_trial.hpp"

namespace blockweir::solid {

class IslandEquations;

class IslandMatrix {
 public:
  IslandMatrix(const Model& model, const StepTrial& trial, const IslandEquations& island)
      : model_(model), trial_(trial), s_(island) {}

  /// The blocks' own matrices on the diagonal, and what triangles of a mesh share beside it.
  template <class System>
  void add_own(System& to) const;
  /// What a contact, support or bolt adds: J^T C J on the diagonal of each block, -J^T C J between the two.
  template <class System>
  void add_stiffness(System& to, const Interaction& action) const {
    add_columns(to, action, false);
    add_columns(to, action, true);
  }
  /// In the columns of one of both blocks.
  template <class System>
  void add_columns(System& to, const Interaction& action, bool of_second) const;

 private:
  const Model& model_;
  const StepTrial& trial_;
  const IslandEquations& s_;
};

}  // namespace blockweir::solid
