// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh's end as the rest of the pool: water comes in and goes out there so that the pool follows its level.
#pragma once

#include <Function1.H>
#include <fvMesh.H>

#include <optional>

#include "fluid/openfoam/plugin/immersed_blocks.hpp"
#include "fluid/openfoam/stokes_wave.hpp"

namespace blockweir::openfoam {

/// Long waves carry u + 2 sqrt(g d) towards the structure. The end lets in what water at rest at the table's level L
/// would: u = 2 (sqrt(g dL) - sqrt(g d)), d the depth found there. A wave that comes back finds nothing to reflect it,
/// and the structure sees the table as late as a long wave is on its way. With regular waves on top, of elevation
/// eta, what comes back has the profile P(y) of their period: u = u_wave + P (L + eta - level found).
class OpenEnd {
 public:
  enum class Side { upstream, downstream };

  /// Entries upstreamLevel (downstreamLevel) and wave of constant/blockweir; the patch's U has to be a fixedValue.
  OpenEnd(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks, const Foam::dictionary& dict, Side side);

  /// Sets the velocity on the end's faces for the step that ends at time_s.
  void set(double time_s);

 private:
  struct Face {
    Foam::label cell = 0;
    double y = 0;
    double height = 0;
  };
  /// The table's mean over the last 4 sqrt(d/g): shorter waves travel so much slower than sqrt(g d) that the end would
  /// reflect them, and none are to set out from the table's corners.
  [[nodiscard]] double smooth_level(double time_s, double depth) const;
  /// At a height above the bed, where `level` was found and `wanted` is the table's [m/s].
  [[nodiscard]] double inflow(double time_s, double bed, double level, double wanted, double y) const;

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  Side side_;
  double gravity_ = 0;  ///< m/s2, downwards
  Foam::label patch_ = -1;
  Foam::autoPtr<Foam::Function1<Foam::scalar>> level_;
  std::optional<StokesWave> wave_;
  std::vector<Face> faces_;  ///< of this rank
};

}  // namespace blockweir::openfoam
