// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of blocks that water answers, in threes: u0, v0, r0 of each block of the scene; then its strains ex, ey, gxy;
// then x, y, and nothing, of each corner of a mesh on a face of its block.
#pragma once

#include <vector>

#include "solid/block/motion.hpp"
#include "solid/block/parts.hpp"

namespace blockweir::solid {

/// What one part has in a motion: rates of the three by the part's six, which of a triangle are those of its corners.
struct MotionShare {
  int part = 0;
  Eigen::Matrix<double, 3, 6> by_rates = Eigen::Matrix<double, 3, 6>::Zero();
};

class WaterMotions {
 public:
  /// The parts must outlive it. Corners of meshes only where the scene's fluid answers their bending.
  WaterMotions(const scene::Scene& scene, const Parts& parts);

  [[nodiscard]] std::size_t count() const { return 2 * blocks_ + corners_.size(); }
  /// Of a block's (u0, v0, r0) that has no mesh, or of any motion that comes after them.
  [[nodiscard]] MotionShare share(std::size_t motion) const;
  /// Velocities of the first `count` motions.
  [[nodiscard]] std::vector<Eigen::Vector3d> velocities(const std::vector<BlockState>& states, std::size_t count) const;
  /// Adds to the forces on blocks (u0, v0, r0) those on corners of their meshes.
  void add_corners(const std::vector<Eigen::Vector3d>& of_motions, const std::vector<Placement>& placements,
                   std::vector<Eigen::Vector3d>& of_blocks) const;

  /// A corner of a triangle, where a side of the outline begins.
  struct Corner {
    int block = 0;
    OutlineSide side;
  };
  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  /// Number of a corner's motion.
  [[nodiscard]] std::size_t motion_of_corner(std::size_t corner) const { return 2 * blocks_ + corner; }

 private:
  const Parts& parts_;
  std::size_t blocks_;  ///< of the scene
  std::vector<Corner> corners_;
};

}  // namespace blockweir::solid
