// SPDX-License-Identifier: GPL-3.0-or-later
// The motions of blocks that cause water pressure, three components each: first u0, v0, r0 of every block; then the
// strains ex, ey, gxy of every block; then x, y (and 0) of every mesh corner on a face, in the order of the message.
#pragma once

#include <Eigen/Geometry>

#include "bridge/process/face_motion.hpp"
#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

class FaceMotions {
 public:
  FaceMotions() = default;
  /// `outlines`: positions of the blocks after `motion`.
  FaceMotions(const scene::Scene& scene, const wire::Motion& motion, const std::vector<std::vector<Point>>& outlines);

  /// Rows of the added mass: one a block if no block strains or bends, else of all motions.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Velocity of a point as a function of the motions' rates, three unknowns a motion; none on a fixed block.
  [[nodiscard]] process::PointMotion operator()(const process::FacePoint& point) const;
  /// Positions of the mesh corners. Between two of them a face stays straight.
  [[nodiscard]] const std::vector<Point>& corners() const { return corners_; }

 private:
  struct Body {
    bool fixed = false;
    bool strains = false;
    Point centroid = Point::Zero();
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
    std::vector<Point> outline;
  };
  /// A mesh corner on a face, and the side of the mesh that begins there.
  struct Corner {
    std::uint32_t edge = 0;
    double s_from = 0;
    double s_to = 1;
    std::size_t next = 0;
  };

  void take_corners(const wire::Motion& motion);
  [[nodiscard]] process::PointMotion of_corners(const process::FacePoint& point) const;

  std::vector<Body> bodies_;
  std::vector<std::vector<std::size_t>> corners_of_;  ///< of each block
  std::vector<Corner> corner_;
  std::vector<Point> corners_;
  std::size_t count_ = 0;
};

}  // namespace blockweir::reservoir
