// SPDX-License-Identifier: GPL-3.0-or-later
// Cells from which blocks leave the water no way out. Its pressure there is that of cells which do not fit the blocks'
// motion: whatever the solver needs to keep the volume of a few cells.
#pragma once

#include <vector>

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

class Pockets {
 public:
  Pockets(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks) : mesh_(mesh), blocks_(blocks) {}

  /// Looks anew where blocks fill other cells than before.
  void find();
  [[nodiscard]] bool hold(int cell) const { return !enclosed_.empty() && enclosed_[static_cast<std::size_t>(cell)]; }

 private:
  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  long fills_ = -1;
  std::vector<bool> enclosed_;
};

}  // namespace blockweir::openfoam
