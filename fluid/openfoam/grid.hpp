// SPDX-License-Identifier: GPL-3.0-or-later
// interFoam's mesh: Cartesian, uniform around the structure, with columns that widen towards both ends.
#pragma once

#include <vector>

#include "fluid/openfoam/site.hpp"

namespace blockweir::openfoam {

/// Columns of the mesh with a constant ratio of neighbouring widths.
struct Stretch {
  double length_m = 0;
  int cells = 0;
  double expansion = 1;  ///< last width over first
};

struct Grid {
  double cell_m = 0;               ///< side of the uniform cells
  std::vector<Stretch> stretches;  ///< from left to right
  std::vector<double> x;           ///< column lines [m]
  std::vector<double> y;           ///< row lines [m], uniform
  double ground_m = 0;             ///< at the upstream end
  double downstream_ground_m = 0;  ///< the same at the downstream end
  Site site;

  [[nodiscard]] std::size_t columns() const { return x.size() - 1; }
  [[nodiscard]] std::size_t rows() const { return y.size() - 1; }
  [[nodiscard]] std::size_t cells() const { return columns() * rows(); }
};

/// Throws std::invalid_argument if the scene has no water to mesh, or the mesh would have over ten million cells.
Grid make_grid(const scene::Scene& scene);

/// Outlines of all blocks; those of the ground are extended beyond the mesh.
std::vector<std::vector<scene::Point>> outlines_in(const Grid& grid, const scene::Scene& scene);

}  // namespace blockweir::openfoam
