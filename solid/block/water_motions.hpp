// SPDX-License-Identifier: GPL-3.0-or-later
// The motions of blocks that cause water pressure, three components each: first u0, v0, r0 of every block of the scene;
// then the strains ex, ey, gxy of every block; then x, y (and 0) of every mesh corner on the outline of a block.
#pragma once

#include <vector>

#include "solid/block/motion.hpp"
#include "solid/block/moving_parts.hpp"

namespace blockweir::solid {

/// How a motion depends on one part: its three rates from the part's six (of a triangle: the velocities of its
/// corners).
struct MotionShare {
  int part = 0;
  Eigen::Matrix<double, 3, 6> by_rates = Eigen::Matrix<double, 3, 6>::Zero();
};

class WaterMotions {
 public:
  /// The parts must outlive it. Mesh corners are included only if the fluid responds to bending.
  WaterMotions(const scene::Scene& scene, const MovingParts& parts);

  [[nodiscard]] std::size_t count() const { return 2 * blocks_ + corners_.size(); }
  /// For u0, v0, r0 of a block without a mesh, and for all strains and corners.
  [[nodiscard]] MotionShare share(std::size_t motion) const;
  /// Velocities of the first `count` motions.
  [[nodiscard]] std::vector<Eigen::Vector3d> velocities(const std::vector<BlockState>& states, std::size_t count) const;
  /// Adds the forces on mesh corners to the forces and moments on their blocks.
  void add_corners(const std::vector<Eigen::Vector3d>& of_motions, const std::vector<Placement>& placements,
                   std::vector<Eigen::Vector3d>& of_blocks) const;

  /// The mesh corner at which a side of the outline begins.
  struct Corner {
    int block = 0;
    OutlineSide side;
  };
  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  /// Index of a corner's motion.
  [[nodiscard]] std::size_t motion_of_corner(std::size_t corner) const { return 2 * blocks_ + corner; }

 private:
  const MovingParts& parts_;
  std::size_t blocks_;  ///< of the scene
  std::vector<Corner> corners_;
};

}  // namespace blockweir::solid
