// SPDX-License-Identifier: GPL-3.0-or-later
// Water that blocks must push, as inertia of their motions.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <utility>
#include <vector>

#include "solid/block/block.hpp"

namespace blockweir::solid {

/// The water's force on motion `a` by an acceleration of motion `b`, the other way [kg/m, kg, kg m].
struct CoupledMass {
  int a = 0;
  int b = 0;
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(a, b, mass);
  }
};

/// M_a of motions in threes: 3x3 matrices on the diagonal, and those of pairs beside it. First come (u0, v0, r0) of the
/// scene's blocks about their centroids where they are now; others, if there are any, are those of WaterMotions.
struct AddedMasses {
  AddedMasses() = default;
  AddedMasses(std::initializer_list<Eigen::Matrix3d> own_ones) : own(own_ones), blocks(own.size()) {}

  std::vector<Eigen::Matrix3d> own;  ///< symmetric [kg/m, kg, kg m]; one a motion, or none
  std::vector<CoupledMass> pairs;    ///< each of motions a < b once
  std::size_t blocks = 0;            ///< how many motions are those of blocks

  [[nodiscard]] bool empty() const { return own.empty(); }
  /// M_a v, of as many motions as there are.
  [[nodiscard]] std::vector<Eigen::Vector3d> times(const std::vector<Eigen::Vector3d>& v) const;
  /// Pairs that join all motions which push the same water, none more than it takes.
  [[nodiscard]] std::vector<std::pair<int, int>> links() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(own, pairs, blocks);
  }
};

/// Largest and smallest eigenvalue of M^-1 M_a over the block's rigid modes, M its own mass.
struct MassRatio {
  double largest = 0;
  double smallest = 0;
};

MassRatio mass_ratio(const Block& block, const Eigen::Matrix3d& added);

}  // namespace blockweir::solid
