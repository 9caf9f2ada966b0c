// SPDX-License-Identifier: GPL-3.0-or-later
// Levels that the scene prescribes: water fractions in the cells of a pool are set anew.
#pragma once

#include <Function1.H>
#include <volFields.H>

#include "fluid/openfoam/plugin/immersed_blocks.hpp"

namespace blockweir::openfoam {

class WaterLevels {
 public:
  /// Entries upstreamLevel, upstreamTo, downstreamLevel, downstreamFrom and setLevels of constant/blockweir.
  WaterLevels(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks);

  /// NaN where there is no pool [m]; where nobody sets it, the one beside the structure.
  [[nodiscard]] double upstream_m(double time_s) const;
  [[nodiscard]] double downstream_m(double time_s) const;

  /// How far the levels that the tables have at both times differ [m].
  [[nodiscard]] double change_m(double from_s, double to_s) const;

  /// What contradicts water at rest at time 0, a user's case being taken as it is; empty: nothing.
  [[nodiscard]] std::string unfit_at_start() const;

  /// Sets fraction and density; velocity and pressure stay, so that the pressure equation finds its level by itself.
  void set(double time_s);

 private:
  struct Cell {
    Foam::label cell = 0;
    double bottom = 0;
    double top = 0;
  };
  struct Pool {
    Foam::autoPtr<Foam::Function1<Foam::scalar>> level;
    double read_at = 0;        ///< x where its level is read [m]
    std::vector<Cell> cells;   ///< whose fraction is set
    std::vector<Cell> column;  ///< of this rank, where its level is read
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
