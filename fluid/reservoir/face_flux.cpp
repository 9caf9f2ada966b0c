// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/face_flux.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "fluid/reservoir/water_matrices.hpp"

namespace blockweir::reservoir {

namespace {

using OnSide = std::vector<std::pair<int, Eigen::Vector3d>>;

/// Accelerations along the normal at a side's three nodes by each unknown that moves it. None on the ground.
void take_side(const BoundarySide& side, const Point& normal, const process::FaceMotion& moves, OnSide& along) {
  along.clear();
  if (side.kind == BoundarySide::Kind::bed) return;
  const std::array<double, 3> s{side.s_from, (side.s_from + side.s_to) / 2, side.s_to};
  for (std::size_t i = 0; i < 3; ++i) {
    const process::PointMotion point = moves({side.block, side.edge, s[i]});
    for (std::size_t k = 0; k < point.unknown.size(); ++k) {
      auto found = std::find_if(along.begin(), along.end(), [&](const auto& a) { return a.first == point.unknown[k]; });
      if (found == along.end()) found = along.insert(found, {point.unknown[k], Eigen::Vector3d::Zero()});
      found->second[static_cast<Eigen::Index>(i)] += normal.dot(point.by_unknown.col(static_cast<Eigen::Index>(k)));
    }
  }
}

}  // namespace

FaceFlux flux_on_faces(const WaterMesh& mesh, const process::FaceMotion& moves) {
  FaceFlux flux;
  flux.ground.setZero(static_cast<Eigen::Index>(mesh.node.size()), 2);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<int> column;  // of each unknown: 0 if it moves no face
  const Eigen::Matrix3d mass = side_mass();
  OnSide along;
  for (const BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::bed && side.kind != BoundarySide::Kind::face) continue;
    const Point span = mesh.node[at(side.node[2])] - mesh.node[at(side.node[0])];
    const Point normal(span.y(), -span.x());  // out of the water, of the side's length
    take_side(side, normal, moves, along);
    for (const auto& [unknown, values] : along) {
      if (at(unknown) >= column.size()) column.resize(at(unknown) + 1, 0);
      column[at(unknown)] = 1;
      const Eigen::Vector3d share = mass * values;
      for (std::size_t row = 0; row < 3; ++row) {
        entries.emplace_back(side.node[row], unknown, share[static_cast<Eigen::Index>(row)]);
      }
    }
    for (std::size_t row = 0; row < 3 && along.empty(); ++row) {
      flux.ground.row(side.node[row]) += mass.row(static_cast<Eigen::Index>(row)).sum() * normal.transpose();
    }
  }
  for (std::size_t unknown = 0; unknown < column.size(); ++unknown) {
    if (column[unknown] == 0) continue;
    column[unknown] = static_cast<int>(flux.unknown.size());
    flux.unknown.push_back(static_cast<int>(unknown));
  }
  for (auto& entry : entries) entry = {entry.row(), column[at(entry.col())], entry.value()};
  flux.g.resize(static_cast<Eigen::Index>(mesh.node.size()), static_cast<Eigen::Index>(flux.unknown.size()));
  flux.g.setFromTriplets(entries.begin(), entries.end());
  return flux;
}

}  // namespace blockweir::reservoir
