// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/added_mass.hpp"

#include <algorithm>

#include "fluid/reservoir/face_flux.hpp"

namespace blockweir::reservoir {
namespace {

/// The linear pressure of the same force and moment as the quadratic one through p: from, middle, to.
Eigen::Vector2d linear_through(const Eigen::Vector3d& p) {
  const double mean = (p[0] + 4 * p[1] + p[2]) / 6;
  const double half_rise = (p[2] - p[0]) / 2;
  return {mean - half_rise, mean + half_rise};
}

/// Nodes of the panel's side, from s_from to s_to: water runs along a block's edges backwards.
std::array<int, 3> nodes_of(const BoundarySide& side) {
  return side.s_from <= side.s_to ? side.node : std::array{side.node[2], side.node[1], side.node[0]};
}

/// Modes of all motions that have a flux, in order, and of the ground.
std::vector<Mode> modes_of(const std::vector<int>& unknowns) {
  std::vector<Mode> modes;
  for (const int unknown : unknowns) {
    const int motion = unknown / 3;
    if (!modes.empty() && modes.back().motion == motion) continue;
    for (int axis = 0; axis < 3; ++axis) modes.push_back({motion, axis});
  }
  modes.push_back({-1, 0});
  modes.push_back({-1, 1});
  return modes;
}

/// nodes x modes. An unknown of a motion may have none.
Eigen::SparseMatrix<double> flux_of(const std::vector<Mode>& modes, const FaceFlux& faces) {
  Eigen::SparseMatrix<double> flux(faces.g.rows(), static_cast<Eigen::Index>(modes.size()));
  std::size_t next = 0;  // of the faces' unknowns
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const auto [motion, axis] = modes[k];
    flux.startVec(column);
    if (motion < 0) {
      for (Eigen::Index i = 0; i < faces.ground.rows(); ++i) {
        if (faces.ground(i, axis) != 0) flux.insertBack(i, column) = faces.ground(i, axis);
      }
    } else if (next < faces.unknown.size() && faces.unknown[next] == 3 * motion + axis) {
      using Entries = Eigen::SparseMatrix<double>::InnerIterator;
      for (Entries g(faces.g, static_cast<Eigen::Index>(next++)); g; ++g) flux.insertBack(g.row(), column) = g.value();
    }
  }
  flux.finalize();
  return flux;
}

}  // namespace

Eigen::MatrixXd WaterAnswer::on_panels(const Eigen::MatrixXd& p) const {
  Eigen::MatrixXd linear(static_cast<Eigen::Index>(2 * panel_nodes.size()), p.cols());
  for (Eigen::Index k = 0; k < p.cols(); ++k) {
    for (std::size_t i = 0; i < panel_nodes.size(); ++i) {
      const auto& [a, b, c] = panel_nodes[i];
      linear.col(k).segment<2>(static_cast<Eigen::Index>(2 * i)) = linear_through({p(a, k), p(b, k), p(c, k)});
    }
  }
  return linear;
}

Eigen::MatrixXd WaterAnswer::pressures(const PressureEquation& equation) const {
  Eigen::MatrixXd pressures(static_cast<Eigen::Index>(2 * panels.size()), flux.cols());
  equation.solve(flux, [&](Eigen::Index first, const Eigen::MatrixXd& p) {
    pressures.middleCols(first, p.cols()) = on_panels(p);
  });
  return pressures;
}

WaterAnswer answer_of(const WaterMesh& mesh, const PressureEquation& equation, const process::FaceMotion& moves) {
  WaterAnswer answer;
  for (const BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::face) continue;
    const auto [from, to] = std::minmax(side.s_from, side.s_to);
    answer.panels.push_back({side.block, side.edge, from, to});
    answer.panel_nodes.push_back(nodes_of(side));
  }
  const FaceFlux faces = flux_on_faces(mesh, moves);
  answer.modes = modes_of(faces.unknown);
  answer.flux = flux_of(answer.modes, faces);
  answer.mass = equation.added_mass(answer.flux);
  return answer;
}

}  // namespace blockweir::reservoir
