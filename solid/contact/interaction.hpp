// SPDX-License-Identifier: GPL-3.0-or-later
// What a contact or a support puts into the equations of the blocks that it joins.
#pragma once

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// One equation that a force is there to fulfil, that force being an unknown: row . separation = 0.
struct Constraint {
  Eigen::Vector2d row = Eigen::Vector2d::Zero();    ///< d violation / d separation
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< what a unit of the unknown force exerts
  double violation = 0;                             ///< m
  double compliance = 0;                            ///< m per N per metre: what keeps redundant constraints apart
};

/// Force and its linearization in a local frame: `axis` and its counter-clockwise perpendicular. Block i gets the force
/// at its point, block j the opposite at its own.
struct Interaction {
  int block_i = -1;
  int block_j = -1;            ///< -1: the ground
  double round_off = 0;        ///< what cancellation leaves uncertain of the force [N per metre]
  Point at_i = Point::Zero();  ///< material points [m]
  Point at_j = Point::Zero();
  Point axis = Point::UnitX();
  Point force = Point::Zero();                          ///< in the local frame [N per metre]
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< -d force / d separation [N/m per metre]
  Point held = Point::Zero();                           ///< weight of axes along which nothing may move; 0 for others

  /// Of the held axes, where slip opens the joint by `opening` of its way (dilation): nothing may then move along
  /// axis - opening * perpendicular.
  [[nodiscard]] Eigen::Matrix2d held_stiffness(double opening) const {
    const Point along(1, -opening);
    Eigen::Matrix2d k = held.x() * along * along.transpose();
    k(1, 1) += held.y();
    return k;
  }

  /// Of one of both ends.
  [[nodiscard]] int block(bool second) const { return second ? block_j : block_i; }
  [[nodiscard]] const Point& at(bool second) const { return second ? at_j : at_i; }

  /// What acts on block i, along global axes.
  [[nodiscard]] Point pull() const { return force.x() * axis + force.y() * perpendicular(axis); }

  /// Rows: the local axes dotted with T of an end's block there.
  [[nodiscard]] Matrix26 shape(const Placement& placement, bool second) const {
    Matrix26 rows;
    rows.row(0) = placement.generalized(axis, at(second));
    rows.row(1) = placement.generalized(perpendicular(axis), at(second));
    return rows;
  }
  /// Of a block whose strains are constant.
  [[nodiscard]] Eigen::Matrix<double, 2, 3> rigid_shape(const Placement& placement, bool second) const {
    Eigen::Matrix<double, 2, 3> rows;
    rows.row(0) = placement.rigid_generalized(axis, at(second));
    rows.row(1) = placement.rigid_generalized(perpendicular(axis), at(second));
    return rows;
  }
};

}  // namespace blockweir::solid
