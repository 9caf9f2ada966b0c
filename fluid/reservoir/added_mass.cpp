// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/added_mass.hpp"

#include <algorithm>
#include <set>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

std::vector<Mode> modes_of(const WaterMesh& mesh, const std::vector<bool>& fixed) {
  std::set<int> wet;
  for (const BoundarySide& side : mesh.side) {
    if (side.kind == BoundarySide::Kind::face && !fixed[at(side.block)]) wet.insert(side.block);
  }
  std::vector<Mode> modes;
  for (const int block : wet) {
    for (int axis = 0; axis < 3; ++axis) modes.push_back({block, axis});
  }
  modes.push_back({-1, 0});
  modes.push_back({-1, 1});
  return modes;
}

Point unit_acceleration(int axis, const Point& arm) {
  if (axis == 0) return {1, 0};
  return axis == 1 ? Point(0, 1) : Point(-arm.y(), arm.x());
}

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

bool moves(const BoundarySide& side, const Mode& mode, const std::vector<bool>& fixed) {
  using Kind = BoundarySide::Kind;
  if (side.kind == Kind::face && !fixed[at(side.block)]) return side.block == mode.block;
  return mode.block < 0 && (side.kind == Kind::face || side.kind == Kind::bed);
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

WaterAnswer answer_of(const WaterMesh& mesh, const PressureEquation& equation, const std::vector<Point>& centroids,
                      const std::vector<bool>& fixed) {
  WaterAnswer answer;
  answer.modes = modes_of(mesh, fixed);
  for (const BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::face) continue;
    const auto [from, to] = std::minmax(side.s_from, side.s_to);
    answer.panels.push_back({side.block, side.edge, from, to});
    answer.panel_nodes.push_back(nodes_of(side));
  }
  const auto count = static_cast<Eigen::Index>(answer.modes.size());
  answer.flux.resize(static_cast<Eigen::Index>(mesh.node.size()), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Mode& mode = answer.modes[static_cast<std::size_t>(k)];
    const Point centre = mode.block < 0 ? Point::Zero() : centroids[at(mode.block)];
    const Eigen::VectorXd flux =
        equation.flux([&](const BoundarySide& side) { return moves(side, mode, fixed); },
                      [&](const Point& x) { return unit_acceleration(mode.axis, x - centre); });
    for (Eigen::Index i = 0; i < flux.size(); ++i) {
      if (flux[i] != 0) answer.flux.insert(i, k) = flux[i];
    }
  }
  answer.flux.makeCompressed();
  answer.pressure.resize(static_cast<Eigen::Index>(2 * answer.panels.size()), count);
  Eigen::MatrixXd work(count, count);  // the water's force on i by a unit of j
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd p = equation.pressure(answer.flux.col(k));
    answer.pressure.col(k) = answer.on_panels(p);
    work.col(k) = answer.flux.transpose() * p;
  }
  answer.mass = -(work + work.transpose()) / 2;
  return answer;
}

}  // namespace blockweir::reservoir
