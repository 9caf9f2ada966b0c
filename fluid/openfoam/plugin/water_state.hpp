// SPDX-License-Identifier: GPL-3.0-or-later
// interFoam's fields as pressure lines: gauge pressure along y in the water of a cell.
#pragma once

#include <uniformDimensionedFields.H>
#include <volFields.H>

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

/// p(y) = at_zero - slope * y [Pa], in the water of a cell or of the one below it.
struct PressureLine {
  bool found = false;  ///< this rank has a usable cell there
  bool wet = false;
  bool whole = false;     ///< the cell is full of water, and no block reaches it
  bool enclosed = false;  ///< by blocks, with a few cells of water
  double at_zero = 0;
  double slope = 0;
  Point centre = Point::Zero();
};

/// Gauge pressure is the excess over still air, scaled so that water at rest has exactly rho_water g depth: (p_rgh +
/// (rho - rho_air) gh) rho_water / (rho_water - rho_air).
class WaterState {
 public:
  WaterState(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks);

  /// Pressure line in the cell at x; `cut`: blocks may reach the cell. A cell that is not full takes the line of the
  /// water in the two cells below it, or, with a block just below, that of the film on the block.
  [[nodiscard]] PressureLine line_at(const Point& x, bool cut = false) const;

  [[nodiscard]] const Foam::fvMesh& mesh() const { return mesh_; }
  [[nodiscard]] double water_density() const { return water_density_; }
  [[nodiscard]] double air_density() const { return air_density_; }

 private:
  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  const Foam::volScalarField& alpha_;
  const Foam::volScalarField& p_rgh_;
  const Foam::volScalarField& rho_;
  double water_density_ = 0;
  double air_density_ = 0;
  double gravity_ = 0;  ///< m/s2, downwards
  double reference_level_ = 0;
  struct Column {
    int below = -1;     ///< the cell below; -1: none on this rank
    double bottom = 0;  ///< of the cell itself
    double height = 0;
  };
  [[nodiscard]] PressureLine film_in(int cell) const;
  std::vector<Column> column_;  ///< by cell
};

}  // namespace blockweir::openfoam
