// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of the structure that the water answers, in threes as messages have them: u0, v0, r0 of each block; then its
// strains ex, ey, gxy; then x, y, and nothing, of each point of faces that the solid names, corners of its meshes.
#pragma once

#include <Eigen/Geometry>

#include "bridge/process/face_motion.hpp"
#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

class FaceMotions {
 public:
  FaceMotions() = default;
  /// Blocks that `motion` has brought to `outlines`.
  FaceMotions(const scene::Scene& scene, const wire::Motion& motion, const std::vector<std::vector<Point>>& outlines);

  /// As many as messages have rows for: blocks alone, where none of them strains or bends.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Velocity of a point by rates of the motions, 3 a motion; of none on a fixed block.
  [[nodiscard]] process::PointMotion operator()(const process::FacePoint& point) const;
  /// Places of the points of faces: between them faces move as straight lines.
  [[nodiscard]] const std::vector<Point>& corners() const { return corners_; }

 private:
  struct Body {
    bool fixed = false;
    bool strains = false;
    Point centroid = Point::Zero();
    Eigen::Rotation2Dd turn{0};
    std::vector<Point> outline;
  };
  /// A point of a face: where its side of the mesh ends, and the point there.
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
