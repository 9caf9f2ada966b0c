// SPDX-License-Identifier: GPL-3.0-or-later
// What sweeps work on: of each contact, support and bolt of an island how its forces move the blocks that it joins.
#pragma once

#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

class SweepRows : StepPart {
 public:
  explicit SweepRows(StepWorkspace& step) : StepPart(step) {}

  /// No rows yet; displacements are those by the island's residual, each block by itself. False where a mesh has no
  /// solution. Again in the same step, only the residual may be another.
  bool begin(IslandEquations& island);
  /// The next row.
  void add(IslandEquations& island, const Ruled& ruled, const Interaction& action, const Eigen::Vector2d& force);
  /// The same in two parts: the next row, between these blocks; and what is in it, of several rows at once, but where
  /// blocks move as one: of the last.
  void add(IslandEquations& island, int block_i, int block_j);
  void set(IslandEquations& island, ForceSweeps::Row& row, const Ruled& ruled, const Interaction& action,
           const Eigen::Vector2d& force);

 private:
  void add_end_of_all(IslandEquations& island, bool second, int block, const Matrix26& shape);
  const Eigen::VectorXd& by_unit_force(IslandEquations& island, int unknown);

  std::vector<Eigen::VectorXd> by_unit_force_;  ///< of unknowns that move others, those asked for
};

}  // namespace blockweir::solid
