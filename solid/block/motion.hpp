// SPDX-License-Identifier: GPL-3.0-or-later
// Where a block is and how its points move: strain first, then an exact turn (1)-(3).
#pragma once

#include <cmath>

#include "solid/block/block.hpp"

namespace blockweir::solid {

/// Counter-clockwise perpendicular.
inline Point perpendicular(const Point& p) {
  return {-p.y(), p.x()};
}

/// E X with E = [[ex, gxy/2], [gxy/2, ey]].
inline Point strained(const Eigen::Ref<const Eigen::Vector3d>& strain, const Point& X) {
  return {strain[0] * X.x() + strain[2] / 2 * X.y(), strain[1] * X.y() + strain[2] / 2 * X.x()};
}

/// What a block's points need of its turn in a step, free of cancellation.
struct Turn {
  double versed = 0;  ///< 1 - cos
  double sine = 0;

  Turn() = default;
  explicit Turn(double radians) : sine(std::sin(radians)) {
    const double half = std::sin(radians / 2);
    versed = 2 * half * half;
  }
};

/// The position and rotation of a block, with the sine and cosine of the angle.
class Placement {
 public:
  Placement() = default;
  Placement(const Point& centroid, const Vector6& displacement)
      : centre_(centroid + displacement.head<2>()),
        moved_(displacement.head<2>()),
        strain_(displacement.tail<3>()),
        cos_(std::cos(displacement[2])),
        sin_(std::sin(displacement[2])) {}

  [[nodiscard]] const Point& centre() const { return centre_; }
  [[nodiscard]] Point turn(const Point& p) const { return {cos_ * p.x() - sin_ * p.y(), sin_ * p.x() + cos_ * p.y()}; }

  /// R^T p: rotates from global axes to the block's own.
  [[nodiscard]] Point unturn(const Point& p) const {
    return {cos_ * p.x() + sin_ * p.y(), -sin_ * p.x() + cos_ * p.y()};
  }
  [[nodiscard]] const Eigen::Vector3d& strain() const { return strain_; }

  /// Vector between two material points, or from the centroid: R (I + E) X.
  [[nodiscard]] Point vector(const Point& X) const { return turn(stretched(X)); }
  [[nodiscard]] Point position(const Point& X) const {
    const Point from_centre = vector(X);
    return {centre_.x() + from_centre.x(), centre_.y() + from_centre.y()};
  }

  /// Displacement of a material point from the scene as drawn, free of cancellation: its round-off error does not grow
  /// with the distance from the origin.
  [[nodiscard]] Point displacement(const Point& X) const {
    const double c1 = cos_ > 0 ? -sin_ * sin_ / (1 + cos_) : cos_ - 1;
    const Point strained_by = strained(strain_, X);
    const Point y = stretched(X);
    return moved_ + strained_by + Point(c1 * y.x() - sin_ * y.y(), sin_ * y.x() + c1 * y.y());
  }

  /// Exact shape matrix T = dx/dd at a material point: columns of u0, v0, r0, ex, ey, gxy.
  [[nodiscard]] Matrix26 shape(const Point& X) const {
    Matrix26 T;
    T.col(0) = Point(1, 0);
    T.col(1) = Point(0, 1);
    T.col(2) = perpendicular(vector(X));
    T.col(3) = turn(Point(X.x(), 0));
    T.col(4) = turn(Point(0, X.y()));
    T.col(5) = turn(Point(X.y() / 2, X.x() / 2));
    return T;
  }

  /// T^T f: the generalized force of a force at a material point.
  [[nodiscard]] Vector6 generalized(const Point& f, const Point& X) const {
    const Point y = stretched(X);
    const Point own = unturn(f);
    Vector6 force;
    force << f, y.x() * own.y() - y.y() * own.x(), X.x() * own.x(), X.y() * own.y(),
        (X.y() * own.x() + X.x() * own.y()) / 2;
    return force;
  }

  /// Its first three: of a block whose strains are constant.
  [[nodiscard]] Eigen::Vector3d rigid_generalized(const Point& f, const Point& X) const {
    const Point y = stretched(X);
    const Point own = unturn(f);
    return {f.x(), f.y(), y.x() * own.y() - y.y() * own.x()};
  }

  /// Displacement of a material point when the six unknowns of this placement change by `increment`, free of
  /// cancellation: R ((R(dr) - I)(I + E) X + R(dr) dE X) + du.
  [[nodiscard]] Point increment(const Vector6& increment, const Turn& turned, const Point& X) const {
    const Point y = stretched(X);
    const Point z = strained(increment.tail<3>(), X);
    const Point moved(-turned.versed * (y.x() + z.x()) - turned.sine * (y.y() + z.y()) + z.x(),
                      turned.sine * (y.x() + z.x()) - turned.versed * (y.y() + z.y()) + z.y());
    const Point turned_back = turn(moved);
    return {increment[0] + turned_back.x(), increment[1] + turned_back.y()};
  }
  [[nodiscard]] Point increment(const Vector6& by, const Point& X) const { return increment(by, Turn(by[2]), X); }

 private:
  /// (I + E) X, number by number: pairs that go through memory cost several times as much.
  [[nodiscard]] Point stretched(const Point& X) const {
    const Point by = strained(strain_, X);
    return {X.x() + by.x(), X.y() + by.y()};
  }

  Point centre_ = Point::Zero();
  Point moved_ = Point::Zero();
  Eigen::Vector3d strain_ = Eigen::Vector3d::Zero();
  double cos_ = 1;
  double sin_ = 0;
};

/// The state of a block that a step changes. For a triangle of a mesh, rates and force are those of its corners (x, y
/// of each) in global axes: inertia is then linear, and triangles agree on shared corners.
struct BlockState {
  Vector6 displacement = Vector6::Zero();
  Vector6 velocity = Vector6::Zero();
  Vector6 acceleration = Vector6::Zero();
  Vector6 force = Vector6::Zero();  ///< all except inertia, at the last accepted step; used by generalized-alpha

  template <class Archive>
  void serialize(Archive& archive) {
    archive(displacement, velocity, acceleration, force);
  }
};

}  // namespace blockweir::solid
