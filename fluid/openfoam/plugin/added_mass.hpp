// SPDX-License-Identifier: GPL-3.0-or-later
// How much water a block has to take along: measured on interFoam's own mesh, by its own operator.
#pragma once

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

/// Water and air that are accelerated from rest by a block's unit acceleration a_k (x, y, rotation about its centroid):
///
///     div((1 - phi)/rho grad p) = div(phi_b a_k),  p = 0 at the atmosphere,  M_jk = -sum p_k div(phi_b a_j) V,
///
/// phi_b what the block fills of a cell and phi what all do: what the penalty lets the pressure equation see.
class AddedMass {
 public:
  AddedMass(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks) : mesh_(mesh), blocks_(blocks) {}

  /// Rows as wire::Load has them: of blocks that can move, zeros for others. Solved for anew where a block has moved by
  /// half a cell since, and every hundredth time as the water moves.
  void measure(std::vector<std::array<double, 6>>& rows);

  [[nodiscard]] long solutions() const { return solutions_; }

 private:
  [[nodiscard]] bool stale() const;
  [[nodiscard]] std::array<double, 6> of_block(std::size_t block);

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  std::vector<std::array<double, 6>> rows_;
  std::vector<Polygon> measured_at_;
  long asked_ = 0;
  long solutions_ = 0;
};

}  // namespace blockweir::openfoam
