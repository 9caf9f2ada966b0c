// SPDX-License-Identifier: GPL-3.0-or-later
// water.csv: what the water does as a whole, and what it does to each block, a row a window.
#pragma once

#include <fstream>
#include <map>

#include "fluid/openfoam/plugin/water_state.hpp"

namespace blockweir::openfoam {

/// Columns: time_s, water_area_m2 (volume over thickness), front_m (the farthest place where the water is deeper than
/// a tenth of its first depth),
/// fastest_m_per_s (in cells of which water fills more than half), ground_acceleration_x_m_per_s2, and of each loaded
/// block force_x_n_per_m, force_y_n_per_m, moment_n (about its centroid) and velocity_x_m_per_s (of its centroid).
class WaterRecord {
 public:
  WaterRecord(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks);

  /// Velocities as in wire::Motion.
  void add(double time_s, const wire::Load& load, const std::vector<Pose>& velocity_of_blocks, double ground_x);

 private:
  [[nodiscard]] double front(double depth_m) const;
  [[nodiscard]] double depth_of(const std::vector<Foam::label>& column) const;

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  std::map<double, std::vector<Foam::label>> columns_;  ///< cells of this rank by the x of their centres
  double deepest_ = 0;                                  ///< water at the start [m]
  std::ofstream file_;                                  ///< the master's
};

}  // namespace blockweir::openfoam
