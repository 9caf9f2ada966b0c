// SPDX-License-Identifier: GPL-3.0-or-later
// What the mesh makes of still water at time 0 against the blocks' exact shapes: where it cannot press a face that
// water reaches, and where a wall is so thin that water goes through it.
#pragma once

#include <string>
#include <vector>

#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

struct Misfit {
  int block = 0;
  scene::Point at;     ///< where it is largest
  double share = 0;    ///< of the force on the block that is wrong
  bool leaks = false;  ///< water goes through the block; else it does not reach its face
};

/// A block a row, those that come out right left out.
std::vector<Misfit> misfits(const scene::Scene& scene, const Grid& grid);

/// Throws std::invalid_argument where more than a hundredth of the force on a block is wrong, with the block's name and
/// the cells_in_depth that it takes; a line for each block where less is.
std::vector<std::string> check_resolution(const scene::Scene& scene, const Grid& grid);

}  // namespace blockweir::openfoam
