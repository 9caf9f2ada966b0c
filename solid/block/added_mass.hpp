// SPDX-License-Identifier: GPL-3.0-or-later
// Added mass: the inertia of water that blocks displace, for their motions.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <utility>
#include <vector>

#include "solid/block/block.hpp"

namespace blockweir::solid {

/// The water's force on motion `a` for an acceleration of motion `b`, with reversed sign [kg/m, kg, kg m].
struct CoupledMass {
  int a = 0;
  int b = 0;
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(a, b, mass);
  }
};

/// Added mass M_a of motions in threes: 3x3 matrices on the diagonal, and those of pairs off it. First (u0, v0, r0) of
/// the scene's blocks about their present centroids; then, if there are any, those of WaterMotions.
struct AddedMasses {
  AddedMasses() = default;
  AddedMasses(std::initializer_list<Eigen::Matrix3d> own_ones) : own(own_ones), blocks(own.size()) {}

  std::vector<Eigen::Matrix3d> own;  ///< symmetric [kg/m, kg, kg m]; one for each motion, or none
  std::vector<CoupledMass> pairs;    ///< pairs of motions a < b, each once
  std::size_t blocks = 0;            ///< number of motions that are those of blocks

  [[nodiscard]] bool empty() const { return own.empty(); }
  /// M_a v, for all motions.
  [[nodiscard]] std::vector<Eigen::Vector3d> times(const std::vector<Eigen::Vector3d>& v) const;
  /// The smallest set of pairs that connects all motions with common water.
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
