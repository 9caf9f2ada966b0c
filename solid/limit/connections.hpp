// SPDX-License-Identifier: GPL-3.0-or-later
// What holds rigid blocks: straight faces between two of them, points in which a corner of one meets the other, and
// ties, which are bolts and held points.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/limit/twist.hpp"

namespace blockweir::solid::limit {

/// A straight piece of the common boundary of two blocks, in the scene's outline, or a point of no length.
struct Face {
  int a = 0;  ///< blocks
  int b = 0;
  int joint = -1;  ///< index into Scene::joints; -1: the default law
  Point from_m;
  Point to_m;
  Point normal;          ///< out of a
  bool in_kink = false;  ///< a point: the corner of one block in a reflex corner of the other
  const scene::JointLaw* law = nullptr;
  double friction = 0;          ///< tan(phi)
  double cohesion_n_per_m = 0;  ///< c L, L what is bonded of it
  double tension_n_per_m = 0;   ///< T L, not beyond the apex of Mohr-Coulomb's cone

  std::vector<scene::StrengthLine> tangents{};  ///< that bound friction which bends, the steepest first

  /// Straight bounds of the shear force [N/m], which is within all of them.
  struct Bound {
    double cohesion_n_per_m = 0;
    double friction = 0;
  };
  [[nodiscard]] std::vector<Bound> bounds() const;
  /// Of friction that bends: does shear go beyond the bound under that normal force [N/m]? Adds the tangent there.
  bool add_tangent(double normal_n_per_m, double shear_n_per_m);

  [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
  [[nodiscard]] Point along() const { return {-normal.y(), normal.x()}; }
  /// Where its normal forces act: one place of a point.
  [[nodiscard]] std::vector<Point> ends() const {
    return length_m() == 0 ? std::vector<Point>{from_m} : std::vector<Point>{from_m, to_m};
  }
};

/// A force between two points along a fixed direction.
struct Tie {
  int a = 0;   ///< block
  int b = -1;  ///< block; -1: the ground
  Point at_a_m;
  Point at_b_m;
  Point direction;         ///< of the force on a
  double low_n_per_m = 0;  ///< bounds of the force, may be infinite
  double high_n_per_m = 0;
};

/// Of all pairs of blocks of which one at least is not fixed.
std::vector<Face> faces_of(const scene::Scene& scene);
std::vector<Tie> ties_of(const scene::Scene& scene);

}  // namespace blockweir::solid::limit
