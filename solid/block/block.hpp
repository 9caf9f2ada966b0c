// SPDX-License-Identifier: GPL-3.0-or-later
// What of a block stays constant: outline about its centroid, mass matrix, elastic stiffness.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid {

using Point = Eigen::Vector2d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix26 = Eigen::Matrix<double, 2, 6>;

/// The six unknowns of a block are (u0, v0, r0, ex, ey, gxy): centroid displacement [m], rotation [rad] and the
/// strains in the block's own, turned frame. Strains live in that frame so that stress and strain rate turn with
/// the block, and both matrices below are constant for the life of the block.
struct Block {
  std::string name;
  Point centroid;               ///< m, in the scene's outline
  std::vector<Point> vertices;  ///< m, relative to the centroid, counter-clockwise
  double area = 0;              ///< m2
  double radius = 0;            ///< m, farthest vertex from the centroid
  bool fixed = false;
  bool rigid = false;                    ///< its strains stay as they are
  std::array<int, 3> nodes{-1, -1, -1};  ///< of a part: a triangle of a block with a mesh
  bool meshed = false;                   ///< its parts move; it follows them as their mean
  Eigen::Matrix3d elasticity;            ///< Hooke's law from (ex, ey, gxy) to (sxx, syy, sxy) [Pa]
  Matrix6 mass;                          ///< integral of density T^T T, T the first-order shape matrix (1)-(3)
  Matrix6 stiffness;                     ///< area * elastic matrix in the strain rows, zero elsewhere [N per metre]
  Matrix6 damping;  ///< Kelvin-Voigt: proportional to the stiffness by the material's damping ratio
  Eigen::Vector3d initial_stress = Eigen::Vector3d::Zero();  ///< (xx, yy, xy) where there is no strain [Pa]

  [[nodiscard]] int unknowns() const { return rigid ? 3 : 6; }
  [[nodiscard]] double mass_per_m() const { return mass(0, 0); }
  [[nodiscard]] bool is_part() const { return nodes[0] >= 0; }
};

Block make_block(const scene::Block& block, const scene::Material& material, scene::Plane plane);

/// 2 zeta / omega, omega the lowest natural frequency at which the free block strains [s]: damping over stiffness.
double retardation_time(const Block& block, double damping_ratio);

/// Stress (xx, yy, xy) [Pa] in the block's own frame from its strains.
Eigen::Vector3d stress_in_block(const Block& block, const Vector6& displacement);

}  // namespace blockweir::solid
