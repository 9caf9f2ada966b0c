// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/added_mass.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
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
std::vector<Mode> modes_of(const std::map<int, Eigen::VectorXd>& flux) {
  std::vector<Mode> modes;
  for (const auto& [unknown, g] : flux) {
    const int motion = unknown / 3;
    if (!modes.empty() && modes.back().motion == motion) continue;
    for (int axis = 0; axis < 3; ++axis) modes.push_back({motion, axis});
  }
  modes.push_back({-1, 0});
  modes.push_back({-1, 1});
  return modes;
}

}  // namespace

Eigen::VectorXd WaterAnswer::on_panels(const Eigen::VectorXd& p) const {
  Eigen::VectorXd linear(static_cast<Eigen::Index>(2 * panel_nodes.size()));
  for (std::size_t i = 0; i < panel_nodes.size(); ++i) {
    const auto& [a, b, c] = panel_nodes[i];
    linear.segment<2>(static_cast<Eigen::Index>(2 * i)) = linear_through({p[a], p[b], p[c]});
  }
  return linear;
}

WaterAnswer answer_of(const WaterMesh& mesh, const PressureEquation& equation, const process::FaceMotion& moves) {
  WaterAnswer answer;
  for (const BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::face) continue;
    const auto [from, to] = std::minmax(side.s_from, side.s_to);
    answer.panels.push_back({side.block, side.edge, from, to});
    answer.panel_nodes.push_back(nodes_of(side));
  }
  const auto of_ground = [&](const BoundarySide& side) {
    using Kind = BoundarySide::Kind;
    if (side.kind == Kind::face) return moves({side.block, side.edge, (side.s_from + side.s_to) / 2}).unknown.empty();
    return side.kind == Kind::bed;
  };
  const std::map<int, Eigen::VectorXd> of_faces = flux_on_faces(mesh, moves);
  answer.modes = modes_of(of_faces);
  const auto count = static_cast<Eigen::Index>(answer.modes.size());
  answer.flux.resize(static_cast<Eigen::Index>(mesh.node.size()), count);
  answer.pressure.setZero(static_cast<Eigen::Index>(2 * answer.panels.size()), count);
  Eigen::MatrixXd work = Eigen::MatrixXd::Zero(count, count);  // the water's force on i by a unit of j
  std::vector<Eigen::VectorXd> pressures(answer.modes.size());
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto [motion, axis] = answer.modes[static_cast<std::size_t>(k)];
    Eigen::VectorXd flux;
    if (motion < 0) {
      flux = equation.flux(of_ground, [axis = axis](const Point&) { return Point(Point::Unit(axis)); });
    } else if (const auto own = of_faces.find(3 * motion + axis); own != of_faces.end()) {
      flux = own->second;
    } else {
      continue;
    }
    for (Eigen::Index i = 0; i < flux.size(); ++i) {
      if (flux[i] != 0) answer.flux.insert(i, k) = flux[i];
    }
    pressures[static_cast<std::size_t>(k)] = equation.pressure(flux);
  }
  answer.flux.makeCompressed();
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd& p = pressures[static_cast<std::size_t>(k)];
    if (p.size() == 0) continue;
    answer.pressure.col(k) = answer.on_panels(p);
    work.col(k) = answer.flux.transpose() * p;
  }
  answer.mass = -(work + work.transpose()) / 2;
  return answer;
}

}  // namespace blockweir::reservoir
