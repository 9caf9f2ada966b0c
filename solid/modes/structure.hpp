// SPDX-License-Identifier: GPL-3.0-or-later
// A structure at rest, linearized: its moving parts, mass and stiffness, with the present states of its joints.
#pragma once

#include <Eigen/SparseCore>

#include "bridge/process/face_motion.hpp"
#include "solid/solve/unknowns.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// The largest stiffness of what gives way: moving blocks that strain, bolts, the ground beyond [Pa, N/m2 for a metre].
/// Of rigid blocks only where nothing else does, as their modulus has no effect then.
double largest_modulus(const Solid& solid);

/// M q'' + K q = 0 for small motions q of a solid at rest. Sticking contacts hold in both directions, slipping ones in
/// the normal direction, open ones not at all; the springs are far stiffer than the blocks. Bolts have their present
/// stiffness. Weight adds no stiffness.
class Structure {
 public:
  /// The solid must outlive the object.
  explicit Structure(const Solid& solid);

  [[nodiscard]] const Eigen::SparseMatrix<double>& mass() const { return mass_; }  ///< kg per metre and the like
  [[nodiscard]] const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }  ///< N per m2 and the like
  [[nodiscard]] int unknowns() const { return unknowns_.total; }
  /// Unit translation of all parts along x (0) or y (1).
  [[nodiscard]] Eigen::VectorXd translation(int axis) const;
  [[nodiscard]] process::PointMotion motion_of(const process::FacePoint& point) const;
  /// Displacement of a material point of a part.
  [[nodiscard]] Point displacement(int part, const Point& material, const Eigen::VectorXd& q) const;

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  void add(int part_i, int part_j, const Matrix6& k, Entries& entries) const;
  void add_blocks(Entries& mass, Entries& stiffness) const;
  void add_holds(Entries& stiffness) const;
  void add_spring(int part_i, const Point& at_i, int part_j, const Point& at_j, const Eigen::Matrix2d& k,
                  Entries& stiffness) const;
  [[nodiscard]] bool moves(int part) const { return part >= 0 && local_[static_cast<std::size_t>(part)] >= 0; }
  [[nodiscard]] int local(int part) const { return local_[static_cast<std::size_t>(part)]; }

  const Solid& solid_;
  std::vector<int> parts_;  ///< indices of the moving parts
  std::vector<int> local_;  ///< for each block of the solid its index in parts_; -1: it does not move
  Unknowns unknowns_;
  Eigen::SparseMatrix<double> mass_;
  Eigen::SparseMatrix<double> stiffness_;
};

}  // namespace blockweir::solid
