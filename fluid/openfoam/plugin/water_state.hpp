// SPDX-License-Identifier: GPL-3.0-or-later
// interFoam's fields as pressure lines: gauge pressure along y in the water of a cell.
#pragma once

#include <uniformDimensionedFields.H>
#include <volFields.H>

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

/// p(y) = at_zero - slope * y [Pa], in the water of a cell or of the one below it.
struct PressureLine {
  bool found = false;  ///< this rank has a cell there that may be looked at
  bool wet = false;
  bool whole = false;  ///< the cell itself is all water, and no block reaches it
  double at_zero = 0;
  double slope = 0;
  Point centre = Point::Zero();
};

/// Gauge pressure here is what exceeds the still air, scaled so that water at rest has rho_water g depth to the last
/// digit: (p_rgh + (rho - rho_air) gh) rho_water / (rho_water - rho_air).
class WaterState {
 public:
  WaterState(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks);

  /// In the cell that holds x, which blocks may reach only if that is asked for. One that is not all water takes the
  /// line of the water in the two cells below it; where a block is just below, that of the film that covers the block.
  [[nodiscard]] PressureLine line_at(const Point& x, bool cut = false) const;

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
