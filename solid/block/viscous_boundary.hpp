// SPDX-License-Identifier: GPL-3.0-or-later
// Ground that goes on beyond the model's faces. On a face with normal n it pulls with
//   t = -Z (v - v_f) + s_f n,   Z = rho (c_p n n^T + c_s (I - n n^T))                        (Lysmer and Kuhlemeyer
//   1969)
// v the face's velocity, v_f and s_f velocity and stress of the free field: the ground without the structure, in which
// a wave of half the base motion comes up and the ground's surface reflects it. Below the model that is -Z (v - 2
// v_up).
#pragma once

#include <vector>

#include "solid/block/base_motion.hpp"
#include "solid/block/parts.hpp"

namespace blockweir::solid {

class ViscousBoundary {
 public:
  ViscousBoundary() = default;
  ViscousBoundary(const scene::Scene& scene, const Parts& parts);

  [[nodiscard]] bool empty() const { return points_.empty(); }
  /// Force of a part's dashpots by its rates: the integral of T^T Z T over its faces, as the scene draws them.
  [[nodiscard]] const Matrix6& drag(std::size_t part) const { return drag_[part]; }
  /// The same of the springs that hold the ground while it comes to rest, and in static analyses.
  [[nodiscard]] const Matrix6& hold(std::size_t part) const { return hold_[part]; }
  /// Adds what the free field exerts on the parts, with velocities as their mean over the step or as at its end.
  void add_free_field(const BaseMotion& base, const scene::TimeSpan& step, bool mean,
                      std::vector<Vector6>& forces) const;

 private:
  /// A point of integration.
  struct BoundaryPoint {
    int part = 0;
    Point material;       ///< m, relative to the part's centroid
    double length_m = 0;  ///< that it stands for
    Point normal;         ///< out of the model
    bool side = false;    ///< beside the model, not below it
    double up_m = 0;      ///< above the lowest point of all faces
    double down_m = 0;    ///< way of what the surface reflects: to it from the lowest point, and back here
    Point speed;          ///< c_s and c_p [m/s]
    Point impedance;      ///< density times these [Pa s/m]
    double lateral = 0;   ///< stress along x over that along y in a wave of pressure that comes up
    [[nodiscard]] Eigen::Matrix2d resistance() const;
  };
  void add(const scene::Scene& scene, const Parts& parts, const scene::ViscousFace& face, double lowest_m,
           double surface_m);
  void add_side(const Parts& parts, const OutlineSide& side, double from, double to, BoundaryPoint like,
                double lowest_m, double surface_m);
  [[nodiscard]] static Point traction(const BoundaryPoint& p, const BaseMotion& base, const scene::TimeSpan& step,
                                      bool mean);

  std::vector<BoundaryPoint> points_;
  std::vector<Matrix6> drag_;  ///< of the parts; none without a viscous face
  std::vector<Matrix6> hold_;
};

}  // namespace blockweir::solid
