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

}  // namespace blockweir::wire
