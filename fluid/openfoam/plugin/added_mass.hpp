// SPDX-License-Identifier: GPL-3.0-or-later
// Added mass of the blocks, computed on interFoam's mesh with its Laplace operator.
#pragma once

#include "fluid/openfoam/plugin/edge_pressures.hpp"

namespace blockweir::openfoam {

/// Pressure of still water for a block's unit acceleration a_k (x, y, rotation about its centroid), on the edges where
/// pressures are sampled:
///
///     -div(grad p_k / rho) = s_k,  p_k = 0 at the atmosphere,  M_jk = sum p_k s_j V,
///
/// with s_k V = sum a_k . n ds over the wet pieces of its edges that sample a cell, and no flow into cells more than
/// half filled by a block. Joints, and pockets too narrow for sampling, do not contribute, as in the load.
class AddedMass {
 public:
  AddedMass(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks, const EdgePressures& edges)
      : mesh_(mesh), blocks_(blocks), edges_(edges) {}

  /// Rows as in wire::Load: for moving blocks, zeros for others. Computed again when a block has moved by half a cell,
  /// and every hundredth time, since the water moves.
  void measure(std::vector<std::array<double, 6>>& rows);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(rows_, measured_at_, asked_);
  }

 private:
  [[nodiscard]] bool stale() const;
  [[nodiscard]] double reach(std::size_t block) const;
  [[nodiscard]] std::array<double, 6> of_block(std::size_t block);
  [[nodiscard]] std::array<Foam::scalarField, 3> sources(std::size_t block) const;
  [[nodiscard]] Foam::wordList pressure_patches() const;

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  const EdgePressures& edges_;
  std::vector<std::array<double, 6>> rows_;
  std::vector<Polygon> measured_at_;
  long asked_ = 0;
};

}  // namespace blockweir::openfoam
