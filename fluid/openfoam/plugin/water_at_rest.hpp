// SPDX-License-Identifier: GPL-3.0-or-later
// Whether anything happens in the water: while nothing does, its last pressures hold and no step need be made.
#pragma once

#include "fluid/openfoam/plugin/water_levels.hpp"

namespace blockweir::openfoam {

/// All by one share e of the largest pressure P = rho g d, d the water's depth. Water is at rest where p_rgh is uniform
/// to e P in each pool, and nowhere faster than u = e c, c = sqrt(g d): a long wave of that speed has the pressure
/// rho c u = e P. A wave that is at its turn fails by the first, one that passes through level by the second. Blocks
/// rest while they are not faster than u, whose waves would be as high, nor farther than e d from where pressures were
/// sampled; nor may a level be.
class WaterAtRest {
 public:
  WaterAtRest(const Foam::fvMesh& mesh, const Foam::dictionary& dict, const ImmersedBlocks& blocks,
              const WaterLevels& levels);

  /// Is the water at rest now, at time_s, with blocks that were told to be at `pose`? The same on all ranks.
  void look(double time_s, const std::vector<Pose>& pose);
  /// Would nothing have happened by the motion's time, had it been at rest?
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
