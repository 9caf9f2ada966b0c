// SPDX-License-Identifier: GPL-3.0-or-later
// Where a material point of a block is, given the six displacements of wire::Motion: strain, then exact turn.
// C++17: the OpenFOAM plugin includes this.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace blockweir::wire {

/// x = c + u + R(r0) (I + E) X, with E = [[ex, gxy/2], [gxy/2, ey]], X = point - centroid in the scene's outline.
/// To first order in r0 and E these are (1)-(3).
inline Eigen::Vector2d place(const Eigen::Vector2d& centroid, const std::array<double, 6>& displacement,
                             const Eigen::Vector2d& point) {
  const auto [u, v, r, ex, ey, gxy] = displacement;
  const Eigen::Vector2d X = point - centroid;
  const Eigen::Vector2d strained(X.x() + ex * X.x() + gxy / 2 * X.y(), X.y() + ey * X.y() + gxy / 2 * X.x());
  const double c = std::cos(r);
  const double s = std::sin(r);
  return {centroid.x() + u + c * strained.x() - s * strained.y(),
          centroid.y() + v + s * strained.x() + c * strained.y()};
}

/// The point of the scene's outline that is at x now: the inverse of place().
inline Eigen::Vector2d unplace(const Eigen::Vector2d& centroid, const std::array<double, 6>& displacement,
                               const Eigen::Vector2d& x) {
  const auto [u, v, r, ex, ey, gxy] = displacement;
  const double c = std::cos(r);
  const double s = std::sin(r);
  const Eigen::Vector2d moved = x - centroid - Eigen::Vector2d(u, v);
  const Eigen::Vector2d turned(c * moved.x() + s * moved.y(), -s * moved.x() + c * moved.y());
  const double det = (1 + ex) * (1 + ey) - gxy * gxy / 4;
  return {centroid.x() + ((1 + ey) * turned.x() - gxy / 2 * turned.y()) / det,
          centroid.y() + ((1 + ex) * turned.y() - gxy / 2 * turned.x()) / det};
}

}  // namespace blockweir::wire
