// SPDX-License-Identifier: GPL-3.0-or-later
// The constant data of a block: outline about its centroid, mass matrix, elastic stiffness.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid {

using geometry::Point;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix26 = Eigen::Matrix<double, 2, 6>;

/// Integral of density T^T T over a block, T the first-order shape matrix (1)-(3) about its centroid: translation is
/// uncoupled from rotation and strains.
class Inertia {
 public:
  Inertia() = default;
  /// Mass [kg per metre]; of (r0, ex, ey, gxy) [kg m2 per metre].
  Inertia(double mass, const Eigen::Matrix4d& of_turn_and_strains) : mass_(mass), rest_(of_turn_and_strains) {}

  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] double of_turn() const { return rest_(0, 0); }
  [[nodiscard]] Vector6 operator*(const Vector6& rate) const {
    Vector6 momentum;
    momentum << mass_ * rate.head<2>(), rest_ * rate.tail<4>();
    return momentum;
  }
  [[nodiscard]] Matrix6 matrix() const {
    Matrix6 all = Matrix6::Zero();
    all(0, 0) = all(1, 1) = mass_;
    all.bottomRightCorner<4, 4>() = rest_;
    return all;
  }

 private:
  double mass_ = 0;
  Eigen::Matrix4d rest_ = Eigen::Matrix4d::Zero();
};

/// Kelvin-Voigt: resistance to strain rate over stiffness [s].
struct Retardation {
  double at_rest_s = 0;
  double sliding_s = 0;
  [[nodiscard]] double of(bool slides) const { return slides ? sliding_s : at_rest_s; }
};

/// The six unknowns of a block are (u0, v0, r0, ex, ey, gxy): centroid displacement [m], rotation [rad] and the
/// strains in the block's own, turned frame. Strains live in that frame so that stress and strain rate turn with
/// the block, and inertia and stiffness are constant for the life of the block.
struct Block {
  Point centroid;               ///< m, in the scene's outline
  std::vector<Point> vertices;  ///< m, relative to the centroid, counter-clockwise
  double area = 0;              ///< m2
  double radius = 0;            ///< m, farthest vertex from the centroid
  bool fixed = false;
  bool rigid = false;                    ///< strains are constant
  std::array<int, 3> nodes{-1, -1, -1};  ///< of a part: a triangle of a block with a mesh
  bool meshed = false;                   ///< its parts move; it has their mean motion
  Eigen::Matrix3d elasticity;            ///< Hooke's law from (ex, ey, gxy) to (sxx, syy, sxy) [Pa]
  Inertia inertia;
  Eigen::Matrix3d stiffness;  ///< of the strains: area * elasticity [N per metre]
  Retardation retardation;
  Eigen::Vector3d initial_stress = Eigen::Vector3d::Zero();  ///< (xx, yy, xy) at zero strain [Pa]
  std::string name;

  [[nodiscard]] int unknowns() const { return rigid ? 3 : 6; }
  [[nodiscard]] double mass_per_m() const { return inertia.mass(); }
  [[nodiscard]] bool is_part() const { return nodes[0] >= 0; }
};

Block make_block(const scene::Block& block, const scene::Material& material, scene::Plane plane);

/// 2 zeta / omega, omega the lowest strain frequency of the free block, zeta the material's damping ratio. If the
/// material states none, zeta is 0.5 for a block that slides: friction is not conservative, and the strains that it
/// couples would flutter (solid/NUMERICS.md).
Retardation retardation_of(const Block& block, const scene::Material& material);

/// Stress (xx, yy, xy) [Pa] in the block's own frame from its strains.
Eigen::Vector3d stress_in_block(const Block& block, const Vector6& displacement);

}  // namespace blockweir::solid
