// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/mesh_motion.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

/// E of six unknowns or of their rates.
Eigen::Matrix2d strain_of(const Vector6& d) {
  return (Eigen::Matrix2d() << d[3], d[5] / 2, d[5] / 2, d[4]).finished();
}

/// I + E.
Eigen::Matrix2d stretch(const Vector6& d) {
  return Eigen::Matrix2d::Identity() + strain_of(d);
}

Eigen::Matrix2d rotation(double angle) {
  return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

const Eigen::Matrix2d quarter_turn = (Eigen::Matrix2d() << 0, -1, 1, 0).finished();

}  // namespace

void follow_triangles(const Model& model, const StepTrial& trial, State& state) {
  if (model.parts.nodes == 0) return;
  for (std::size_t b = 0; b < model.described(); ++b) {
    if (!model.blocks[b].meshed) continue;
    Point moved = Point::Zero();
    Point velocity = Point::Zero();
    Eigen::Matrix2d F = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d F_rate = Eigen::Matrix2d::Zero();
    for (const int part : model.parts.triangles[b]) {
      const BlockState& triangle = state.blocks[at(part)];
      const double share = model.blocks[at(part)].area / model.blocks[b].area;
      moved += share * triangle.displacement.head<2>();
      F += share * rotation(triangle.displacement[2]) * stretch(triangle.displacement);
      const Vector6 rates = trial.rate(at(part), state.placements[at(part)], triangle.velocity);
      velocity += share * rates.head<2>();
      F_rate += share * rotation(triangle.displacement[2]) *
                (rates[2] * quarter_turn * stretch(triangle.displacement) + strain_of(rates));
    }
    Vector6& d = state.blocks[b].displacement;
    const double turned = std::atan2(F(1, 0) - F(0, 1), F(0, 0) + F(1, 1));
    const double turn = d[2] + std::remainder(turned - d[2], 2 * std::numbers::pi);
    const Eigen::Matrix2d U = rotation(-turn) * F;
    const Eigen::Matrix2d U_rate = rotation(-turn) * F_rate;
    const double spin = (U_rate(1, 0) - U_rate(0, 1)) / U.trace();
    const Eigen::Matrix2d strain_rate = U_rate - spin * quarter_turn * U;
    d << moved, turn, U(0, 0) - 1, U(1, 1) - 1, U(0, 1) + U(1, 0);
    state.blocks[b].velocity << velocity, spin, strain_rate(0, 0), strain_rate(1, 1),
        strain_rate(0, 1) + strain_rate(1, 0);
    state.placements[b] = Placement(model.blocks[b].centroid, d);
  }
}

}  // namespace blockweir::solid
