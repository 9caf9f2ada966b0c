// SPDX-License-Identifier: GPL-3.0-or-later
// An open boundary at the end of the mesh: water enters and leaves so that the pool follows its level.
#pragma once

#include <Function1.H>
#include <fvMesh.H>

#include <optional>

#include "fluid/openfoam/plugin/immersed_blocks.hpp"
#include "fluid/openfoam/stokes_wave.hpp"

namespace blockweir::openfoam {

/// Long waves carry u + 2 sqrt(g d) towards the structure. The boundary prescribes the inflow of water at rest at the
/// table's level L: u = 2 (sqrt(g dL) - sqrt(g d)), where d is the depth found there. Outgoing waves are not reflected,
/// and the structure sees the table with the delay of a long wave. With regular waves of elevation eta in addition, the
/// returning part has the profile P(y) of their period: u = u_wave + P (L + eta - level found).
class OpenEnd {
 public:
  enum class Side { upstream, downstream };

  /// Uses entries upstreamLevel (downstreamLevel) and wave of constant/blockweir; the patch's U must be a fixedValue.
  OpenEnd(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks, const Foam::dictionary& dict, Side side);

  /// Sets the velocity on the boundary's faces for the step that ends at time_s.
  void set(double time_s);

 private:
  struct Face {
    Foam::label cell = 0;
    double y = 0;
    double height = 0;
  };
  /// Mean of the table over the last 4 sqrt(d/g). Shorter waves travel so much slower than sqrt(g d) that the boundary
  /// would reflect them; corners of the table must not produce such waves.
  [[nodiscard]] double smooth_level(double time_s, double depth) const;
  /// At a height above the bed; `level` was found, `wanted` is the table's [m/s].
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
