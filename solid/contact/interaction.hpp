// SPDX-License-Identifier: GPL-3.0-or-later
// What a contact or a support puts into the equations of the blocks that it joins.
#pragma once

#include <array>

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// One equation that a force is there to fulfil, that force being an unknown: row . separation = 0.
struct Constraint {
  Eigen::Vector2d row = Eigen::Vector2d::Zero();    ///< d violation / d separation
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< what a unit of the unknown force exerts
  double violation = 0;                             ///< m
  double compliance = 0;                            ///< m per N per metre: what keeps redundant constraints apart
};

/// Force and its linearization in a local frame of two axes. Block i gets shape_i^T force, block j its opposite.
struct Interaction {
  int block_i = -1;
  int block_j = -1;  ///< -1: the ground
  int constraint_count = 0;
  double round_off = 0;  ///< what cancellation leaves uncertain of the force [N per metre]
  Matrix26 shape_i;      ///< rows: local axes dotted with T of block i at the point
  Matrix26 shape_j;
  Eigen::Vector2d force = Eigen::Vector2d::Zero();      ///< N per metre
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< -d force / d separation [N/m per metre]
  Eigen::Vector2d held = Eigen::Vector2d::Zero();       ///< weight of axes along which nothing may move; 0 for others
  std::array<Constraint, 2> constraints;                ///< instead of stiffness where forces are unknowns

  [[nodiscard]] bool acts() const { return constraint_count > 0 || !stiffness.isZero(0) || !force.isZero(0); }
};

}  // namespace blockweir::solid
