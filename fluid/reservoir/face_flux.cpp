// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/face_flux.hpp"

#include "bridge/scene/at.hpp"
#include "fluid/reservoir/water_matrices.hpp"

namespace blockweir::reservoir {

std::map<int, Eigen::VectorXd> flux_on_faces(const WaterMesh& mesh, const process::FaceMotion& moves) {
  std::map<int, Eigen::VectorXd> flux;
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
        auto& g = flux.try_emplace(point.unknown[k], Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.node.size())))
                      .first->second;
        for (std::size_t row = 0; row < 3; ++row) {
          g[side.node[row]] += along * mass(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i));
        }
      }
    }
  }
  return flux;
}

}  // namespace blockweir::reservoir
