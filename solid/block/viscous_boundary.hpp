// SPDX-License-Identifier: GPL-3.0-or-later
// Viscous boundary: ground that continues beyond the model's faces. Its traction on a face with normal n is
//   t = -Z (v - v_f) + s_f n,   Z = rho (c_p n n^T + c_s (I - n n^T))   (Lysmer and Kuhlemeyer 1969)
// where v is the face's velocity, v_f and s_f are velocity and stress of the free field. The free field is the ground
// without the structure: a rising wave with half the base motion, and its reflection
// at the ground's surface.
// Below the model this is -Z (v - 2 v_up).
#pragma once

#include <vector>

#include "solid/block/base_motion.hpp"
#include "solid/block/moving_parts.hpp"

namespace blockweir::solid {

class ViscousBoundary {
 public:
  ViscousBoundary() = default;
  ViscousBoundary(const scene::Scene& scene, const MovingParts& parts);

  [[nodiscard]] bool empty() const { return points_.empty(); }
  /// Damping matrix of a part: the integral of T^T Z T over its faces as drawn.
  [[nodiscard]] const Matrix6& drag(std::size_t part) const { return drag_[part]; }
  /// Stiffness matrix of the springs that hold the ground in the initial equilibrium and in static analyses.
  [[nodiscard]] const Matrix6& hold(std::size_t part) const { return hold_[part]; }
  /// Adds the forces of the free field on the parts, with velocities as the step's mean or at its end.
  void add_free_field(const BaseMotion& base, const scene::TimeSpan& step, bool mean,
                      std::vector<Vector6>& forces) const;

 private:
  /// An integration point.
  struct BoundaryPoint {
    int part = 0;
    Point material;       ///< m, relative to the part's centroid
    double length_m = 0;  ///< length that it represents
    Point normal;         ///< out of the model
    bool side = false;    ///< beside the model, not below it
    double up_m = 0;      ///< above the lowest point of all faces
    double down_m = 0;    ///< path of the reflected wave: from the lowest point to the surface, and back here
    Point speed;          ///< c_s and c_p [m/s]
    Point impedance;      ///< density times these [Pa s/m]
    double lateral = 0;   ///< horizontal over vertical stress in a rising pressure wave
    [[nodiscard]] Eigen::Matrix2d resistance() const;
  };
  void add(const scene::Scene& scene, const MovingParts& parts, const scene::ViscousFace& face, double lowest_m,
           double surface_m);
  void add_side(const MovingParts& parts, const OutlineSide& side, double from, double to, BoundaryPoint like,
                double lowest_m, double surface_m);
  [[nodiscard]] static Point traction(const BoundaryPoint& p, const BaseMotion& base, const scene::TimeSpan& step,
                                      bool mean);

  std::vector<BoundaryPoint> points_;
  std::vector<Matrix6> drag_;  ///< for each part; empty without a viscous face
  std::vector<Matrix6> hold_;
};

}  // namespace blockweir::solid
