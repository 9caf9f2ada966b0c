// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/face_flux.hpp"

#include <map>

#include "bridge/scene/at.hpp"
#include "fluid/reservoir/water_matrices.hpp"

namespace blockweir::reservoir {

FaceFlux flux_on_faces(const WaterMesh& mesh, const process::FaceMotion& moves) {
  std::map<int, std::vector<Eigen::Triplet<double>>> entries;  // of each unknown, in the order of the sides
  const Eigen::Matrix3d mass = side_mass();
  for (const BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::face) continue;
    const Point span = mesh.node[at(side.node[2])] - mesh.node[at(side.node[0])];
    const Point normal(span.y(), -span.x());  // out of the water, of the side's length
    const std::array<double, 3> s{side.s_from, (side.s_from + side.s_to) / 2, side.s_to};
    for (std::size_t i = 0; i < 3; ++i) {
      const process::PointMotion point = moves({side.block, side.edge, s[i]});
      for (std::size_t k = 0; k < point.unknown.size(); ++k) {
        const double along = normal.dot(point.by_unknown.col(static_cast<Eigen::Index>(k)));
        auto& g = entries[point.unknown[k]];
        for (std::size_t row = 0; row < 3; ++row) {
          g.emplace_back(side.node[row], 0, along * mass(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i)));
        }
      }
    }
  }
  FaceFlux flux;
  std::vector<Eigen::Triplet<double>> all;
  for (const auto& [unknown, own] : entries) {
    for (const auto& entry : own) all.emplace_back(entry.row(), static_cast<int>(flux.unknown.size()), entry.value());
    flux.unknown.push_back(unknown);
  }
  flux.g.resize(static_cast<Eigen::Index>(mesh.node.size()), static_cast<Eigen::Index>(flux.unknown.size()));
  flux.g.setFromTriplets(all.begin(), all.end());
  return flux;
}

}  // namespace blockweir::reservoir
