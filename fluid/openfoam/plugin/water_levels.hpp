// SPDX-License-Identifier: GPL-3.0-or-later
// Prescribed levels: sets the water fraction in the cells of a pool.
#pragma once

#include <Function1.H>
#include <volFields.H>

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

class WaterLevels {
 public:
  /// Uses entries upstreamLevel, upstreamTo, downstreamLevel, downstreamFrom and setLevels of constant/blockweir.
  WaterLevels(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks);

  /// NaN if there is no pool [m]; if the level is not prescribed, the one beside the structure.
  [[nodiscard]] double upstream_m(double time_s) const;
  [[nodiscard]] double downstream_m(double time_s) const;

  /// Difference of the tables' levels at both times [m].
  [[nodiscard]] double change_m(double from_s, double to_s) const;

  /// Why the initial state of a user's case is not hydrostatic; empty: it is.
  [[nodiscard]] std::string unfit_at_start() const;

  /// Sets fraction and density. Velocity and pressure stay, and the pressure equation adapts.
  void set(double time_s);

 private:
  struct Cell {
    Foam::label cell = 0;
    double bottom = 0;
    double top = 0;
  };
  struct Pool {
    Foam::autoPtr<Foam::Function1<Foam::scalar>> level;
    double read_at = 0;        ///< x where its level is measured [m]
    std::vector<Cell> cells;   ///< whose fraction is set
    std::vector<Cell> column;  ///< of this rank, where its level is measured
  };
  [[nodiscard]] double level(const Pool& pool, double time_s) const;
  [[nodiscard]] double found_level(const Pool& pool) const;
  [[nodiscard]] std::string unfit_at_start(const Pool& pool, const char* name) const;
  void set(Pool& pool, double time_s);

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  bool set_levels_ = false;
  double water_density_ = 0;
  double air_density_ = 0;
  Pool upstream_;
  Pool downstream_;
};

}  // namespace blockweir::openfoam
