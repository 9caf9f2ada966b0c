// SPDX-License-Identifier: GPL-3.0-or-later
// water.csv: quantities of the water as a whole and its forces on each block, one row for each window.
#pragma once

#include <map>
#include <optional>

#include "bridge/results/result_file.hpp"
#include "fluid/openfoam/plugin/water_state.hpp"

namespace blockweir::openfoam {

/// Columns: time_s, upstream_level_m and downstream_level_m (as sent to the solid), water_area_m2 (volume over
/// thickness), front_m (the farthest place where the water is deeper than a tenth of its first depth), fastest_m_per_s
/// (in cells more than half full of water), ground_acceleration_x_m_per_s2, and for each loaded block force_x_n_per_m,
/// force_y_n_per_m, moment_n (about its centroid) and velocity_x_m_per_s (of its centroid).
class WaterRecord {
 public:
  /// `goes_on`: appends to the file of the resumed run.
  WaterRecord(const Foam::fvMesh& mesh, const ImmersedBlocks& blocks, bool goes_on);

  /// Velocities as in wire::Motion.
  void add(double time_s, const wire::Load& load, const std::vector<Pose>& velocity_of_blocks, double ground_x);

  template <class Archive>
  void save(Archive& archive) const {
    archive(deepest_, file_ ? file_->size() : 0);
  }
  template <class Archive>
  void load(Archive& archive) {
    std::uintmax_t size = 0;
    archive(deepest_, size);
    if (file_) file_->cut_to(size);
  }

 private:
  [[nodiscard]] double front(double depth_m) const;
  [[nodiscard]] double depth_of(const std::vector<Foam::label>& column) const;

  const Foam::fvMesh& mesh_;
  const ImmersedBlocks& blocks_;
  std::map<double, std::vector<Foam::label>> columns_;  ///< cells of this rank by the x of their centres
  double deepest_ = 0;                                  ///< water at the start [m]
  std::optional<results::ResultFile> file_;             ///< the master's
};

}  // namespace blockweir::openfoam
