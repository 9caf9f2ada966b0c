// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the mesh's hydrostatic forces at time 0 against the exact shapes: faces that the mesh cannot load, and walls
// so thin that water leaks through.
#pragma once

#include <string>
#include <vector>

#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

struct Misfit {
  int block = 0;
  scene::Point at;     ///< where the error is largest
  double share = 0;    ///< wrong share of the force on the block
  bool leaks = false;  ///< water leaks through the block; otherwise it does not reach its face
};

/// One row for each block with an error.
std::vector<Misfit> misfits(const scene::Scene& scene, const Grid& grid);

/// Throws std::invalid_argument if more than a hundredth of the force on a block is wrong, with the block's name and
/// the required cells_in_depth. Returns a line for each block with a smaller error.
std::vector<std::string> check_resolution(const scene::Scene& scene, const Grid& grid);

}  // namespace blockweir::openfoam
