// SPDX-License-Identifier: GPL-3.0-or-later
// Connections between rigid blocks: faces between two blocks, points where a corner of one touches another, and ties
// (bolts and supports).
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/limit/twist.hpp"

namespace blockweir::solid::limit {

/// A straight piece of the common boundary of two blocks as drawn, or a point without length.
struct Face {
  int a = 0;  ///< blocks
  int b = 0;
  int joint = -1;  ///< index into Scene::joints; -1: the default law
  Point from_m;
  Point to_m;
  Point normal;          ///< out of a
  bool in_kink = false;  ///< a point: the block's corner lies in a reflex corner of the other
  const scene::JointLaw* law = nullptr;
  double friction = 0;          ///< tan(phi)
  double cohesion_n_per_m = 0;  ///< c L, L the bonded length
  double tension_n_per_m = 0;   ///< T L, limited to the apex of Mohr-Coulomb's cone

  std::vector<scene::StrengthLine> tangents{};  ///< tangents of a curved friction law, the steepest first

  /// Linear bounds of the shear force [N/m]; all of them hold.
  struct Bound {
    double cohesion_n_per_m = 0;
    double friction = 0;
  };
  [[nodiscard]] std::vector<Bound> bounds() const;
  /// For curved friction: whether shear exceeds the bound at this normal force [N/m]. If so, adds the tangent there.
  bool add_tangent(double normal_n_per_m, double shear_n_per_m);

  [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
  [[nodiscard]] Point along() const { return {-normal.y(), normal.x()}; }
  /// Points where its normal forces act; a point contact has one.
  [[nodiscard]] std::vector<Point> ends() const {
    return length_m() == 0 ? std::vector<Point>{from_m} : std::vector<Point>{from_m, to_m};
  }
};

/// A force between two points in a fixed direction.
struct Tie {
  int a = 0;   ///< block
  int b = -1;  ///< block; -1: the ground
  Point at_a_m;
  Point at_b_m;
  Point direction;         ///< of the force on a
  double low_n_per_m = 0;  ///< bounds of the force, may be infinite
  double high_n_per_m = 0;
};

/// Connections of all pairs of blocks that are not both fixed.
std::vector<Face> faces_of(const scene::Scene& scene);
std::vector<Tie> ties_of(const scene::Scene& scene);

}  // namespace blockweir::solid::limit
