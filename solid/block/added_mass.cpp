// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/added_mass.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

std::vector<Eigen::Vector3d> AddedMasses::times(const std::vector<Eigen::Vector3d>& v) const {
  std::vector<Eigen::Vector3d> product(own.size());
  for (std::size_t b = 0; b < own.size(); ++b) product[b] = own[b] * v[b];
  for (const CoupledMass& pair : pairs) {
    product[at(pair.a)] += pair.mass * v[at(pair.b)];
    product[at(pair.b)] += pair.mass.transpose() * v[at(pair.a)];
  }
  return product;
}

std::vector<std::pair<int, int>> AddedMasses::links() const {
  std::vector<int> lower(own.size());
  std::iota(lower.begin(), lower.end(), 0);
  const auto lowest = [&](int b) {
    while (lower[at(b)] != b) b = lower[at(b)];
    return b;
  };
  std::vector<std::pair<int, int>> links;
  for (const CoupledMass& pair : pairs) {
    const int of_a = lowest(pair.a);
    const int of_b = lowest(pair.b);
    if (of_a == of_b) continue;
    lower[at(std::max(of_a, of_b))] = std::min(of_a, of_b);
    links.emplace_back(pair.a, pair.b);
  }
  return links;
}

MassRatio mass_ratio(const Block& block, const Eigen::Matrix3d& added) {
  // About the centroid the block's own rigid mass is diagonal.
  const Eigen::Vector3d scale = block.inertia.matrix().diagonal().head<3>().cwiseSqrt().cwiseInverse();
  const Eigen::Matrix3d scaled = scale.asDiagonal() * added * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(scaled, Eigen::EigenvaluesOnly);
  return {modes.eigenvalues().maxCoeff(), modes.eigenvalues().minCoeff()};
}

}  // namespace blockweir::solid
