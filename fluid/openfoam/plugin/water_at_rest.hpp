// SPDX-License-Identifier: GPL-3.0-or-later
// Detects water at rest: while it lasts, the last pressures hold and no step is made.
#pragma once

#include "fluid/openfoam/plugin/water_levels.hpp"

namespace blockweir::openfoam {

/// All limits use one share e of the largest pressure P = rho g d, d the water's depth. Water is at rest if p_rgh is
/// uniform to e P in each pool and no velocity exceeds u = e c, c = sqrt(g d): a long wave of that speed has the
/// pressure rho c u = e P. A wave at its turning point violates the first condition, a passing one the second. Blocks
/// are at rest if they are not faster than u, since they would make waves of that height, and not farther than e d from
/// their positions at the last sampling. A level must not have moved farther either.
class WaterAtRest {
 public:
  WaterAtRest(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks,
              const WaterLevels& levels);

  /// Checks whether the water is at rest at time_s, for blocks sent as `pose`. The same on all ranks.
  void look(double time_s, const std::vector<Pose>& pose);
  /// Whether water at rest stays so until the motion's time.
  [[nodiscard]] bool lasts(const wire::Motion& motion, double from_s, const std::vector<Pose>& before) const;

 private:
  using Cells = std::vector<Foam::label>;
  [[nodiscard]] bool uniform(const Cells& pool) const;
  [[nodiscard]] bool slow() const;
  [[nodiscard]] double farthest(const wire::Column<Pose>& a, const std::vector<Pose>& b) const;

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  const WaterLevels& levels_;
  Cells upstream_;  ///< of this rank, beside the structure
  Cells downstream_;
  double tolerance_ = 0;
  double depth_m_ = 0;
  double pressure_pa_ = 0;    ///< e P
  double speed_m_per_s_ = 0;  ///< u
  bool rests_ = false;
  double looked_s_ = 0;
  std::vector<Pose> looked_at_;
};

}  // namespace blockweir::openfoam
