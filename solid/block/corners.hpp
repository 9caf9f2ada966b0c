// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle's motion described by its three corners: the nodes that the triangles of a mesh share.
#pragma once

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// Rows: displacements (x, y) of the three corners per unit of the six unknowns, at this placement.
inline Matrix6 corner_shape(const Block& triangle, const Placement& placement) {
  Matrix6 V;
  for (int i = 0; i < 3; ++i) {
    V.middleRows<2>(2 * i) = placement.shape(triangle.vertices[static_cast<std::size_t>(i)]);
  }
  return V;
}

/// Its inverse: rates of the six unknowns from those of the corners. In the triangle's own frame the corners' rates are
/// w(X) = w0 + G X with G = r P (I + E) + dE/dt, P the rotation by 90 degrees: its antisymmetric part gives r, the rest
/// dE/dt.
inline Matrix6 corner_map(const Block& triangle, const Placement& placement) {
  const auto& X = triangle.vertices;
  const Eigen::Vector3d& e = placement.strain();
  const double stretch = 2 + e[0] + e[1];
  Matrix6 map = Matrix6::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point g = perpendicular(X[(i + 2) % 3] - X[(i + 1) % 3]) / (2 * triangle.area);  // of the corner's share
    for (int axis = 0; axis < 2; ++axis) {
      const Point w = placement.unturn(Point::Unit(axis));
      const Eigen::Matrix2d G = w * g.transpose();
      const double r = (G(1, 0) - G(0, 1)) / stretch;
      auto column = map.col(2 * static_cast<Eigen::Index>(i) + axis);
      column[axis] = 1.0 / 3;
      column.tail<4>() << r, G(0, 0) + r * e[2] / 2, G(1, 1) - r * e[2] / 2, G(0, 1) + G(1, 0) - r * (e[0] - e[1]);
    }
  }
  return map;
}

/// Consistent mass matrix of the corners, in global axes and therefore constant during rotation.
inline Matrix6 corner_mass(const Block& triangle) {
  Eigen::Matrix3d shares = Eigen::Matrix3d::Ones();
  shares.diagonal().setConstant(2);
  Matrix6 mass = Matrix6::Zero();
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = i % 2; j < 6; j += 2) mass(i, j) = triangle.mass_per_m() / 12 * shares(i / 2, j / 2);
  }
  return mass;
}

/// The increment of the six unknowns that moves the corners (x, y of each) from `start` by `moved`, exactly: of
/// the deformation gradient F = R (I + E) the rotation angle is that of R, the strain the rest. Free of
/// cancellation.
inline Vector6 increment_of(const Block& triangle, const Placement& start, const Vector6& moved) {
  const auto& X = triangle.vertices;
  Eigen::Matrix2d G = Eigen::Matrix2d::Zero();  // R^T (F - F at start)
  for (std::size_t i = 0; i < 3; ++i) {
    const Point gradient = perpendicular(X[(i + 2) % 3] - X[(i + 1) % 3]) / (2 * triangle.area);
    G += start.unturn(moved.segment<2>(static_cast<Eigen::Index>(2 * i))) * gradient.transpose();
  }
  const Eigen::Vector3d& e = start.strain();
  Eigen::Matrix2d U;  // I + E, as rotated from the start
  U << 1 + e[0] + G(0, 0), e[2] / 2 + G(0, 1), e[2] / 2 + G(1, 0), 1 + e[1] + G(1, 1);
  const double turn = std::atan2(G(1, 0) - G(0, 1), U(0, 0) + U(1, 1));
  const double s = std::sin(turn);
  const double c1 = -2 * std::pow(std::sin(turn / 2), 2);  // cos - 1
  const Eigen::Matrix2d back = (Eigen::Matrix2d() << c1, s, -s, c1).finished();
  const Eigen::Matrix2d strained = G + back * U;
  Vector6 d;
  d.head<2>() = (moved.head<2>() + moved.segment<2>(2) + moved.tail<2>()) / 3;
  d.tail<4>() << turn, strained(0, 0), strained(1, 1), strained(0, 1) + strained(1, 0);
  return d;
}

}  // namespace blockweir::solid
