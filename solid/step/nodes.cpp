// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks with a mesh in a step: their nodes are the unknowns, triangles follow from their corners, and the block
// follows its triangles as their mean.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"
#include "solid/step/solid.hpp"

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

/// Rate of the six unknowns at a placement, from the state's.
Vector6 Solid::rate(std::size_t b, const Placement& placement, const Vector6& of_state) const {
  if (!blocks_[b].is_part() || of_state.isZero(0)) return of_state;
  return corner_map(blocks_[b], placement) * of_state;
}

/// A generalized force as the state has it.
Vector6 Solid::at_corners(std::size_t b, const Vector6& force) const {
  if (!blocks_[b].is_part()) return force;
  return corner_map(blocks_[b], placement_[b]).transpose() * force;
}

Matrix6 Solid::inertia(std::size_t b) const {
  Matrix6 mass = blocks_[b].is_part() ? corner_mass(blocks_[b]) : blocks_[b].inertia.matrix();
  if (b < guard_.blocks()) mass.topLeftCorner<3, 3>() += guard_.mass(b);
  return mass;
}

Vector6 Solid::corner_increment(std::size_t t) const {
  Vector6 moved;
  for (int i = 0; i < 3; ++i) moved.segment<2>(2 * i) = node_increment_[at(blocks_[t].nodes[at(i)])];
  return moved;
}

/// Nodes go on at their velocity.
void Solid::predict_nodes(double dt) {
  for (std::size_t t = described(); t < blocks_.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      node_increment_[at(blocks_[t].nodes[at(i)])] = (frozen_[t] ? 0 : dt) * states_[t].velocity.segment<2>(2 * i);
    }
  }
  for (std::size_t t = described(); t < blocks_.size(); ++t) follow_corners(t);
}

void Solid::follow_corners(std::size_t t) {
  increment_[t] = increment_of(blocks_[t], start_[t], corner_increment(t));
  placement_[t] = Placement(blocks_[t].centroid, states_[t].displacement + increment_[t]);
}

void Solid::set_corner_maps(IslandSystem& s) {
  for (int k = 0; k < s.unknowns->blocks(); ++k) {
    const auto b = at(s.island.blocks[at(k)]);
    if (blocks_[b].is_part()) s.unknowns->set_map(k, corner_map(blocks_[b], placement_[b]));
  }
}

void Solid::balance_couplings(IslandSystem& s) {
  const auto retarded = [this](std::size_t t) -> Eigen::Vector3d {
    const Vector6 velocity = newmark_.velocity_factor(matrices_dt_) * increment_[t] + past_velocity_[t];
    return (states_[t].displacement + increment_[t] + retardation_s(t) * velocity).tail<3>();
  };
  for (const int k : s.couplings) {
    const StrainCoupling& c = parts_.couplings[at(k)];
    balance_[at(c.i)].tail<3>() -= c.stiffness * retarded(at(c.j));
    balance_[at(c.j)].tail<3>() -= c.stiffness * retarded(at(c.i));
  }
}

/// Balance less inertia, to the triangle's corners; so is what round-off leaves uncertain.
void Solid::add_residual_at_corners(IslandSystem& s, int k) {
  constexpr double corner_share = 4;  // of a block's force that may fall to one corner, slender triangles included
  const auto t = at(s.island.blocks[at(k)]);
  const Vector6 pull = newmark_.mass_factor(matrices_dt_) * (corner_mass(blocks_[t]) * corner_increment(t));
  s.unknowns->add(k, balance_[t], s.residual);
  const Vector6 left = history_[t] - pull;
  const double noise = round_off_[t] + sum_round_off * (pull.cwiseAbs().maxCoeff() + history_[t].cwiseAbs().maxCoeff());
  const auto& numbers = s.unknowns->of(k);
  for (Eigen::Index i = 0; i < 6; ++i) {
    s.residual[numbers[at(static_cast<int>(i))]] += left[i];
    s.uncertain[numbers[at(static_cast<int>(i))]] += corner_share * noise;
  }
}

double Solid::unbalanced_at_nodes(const IslandSystem& s) {
  double unbalanced = 0;
  for (const auto& [node, first] : s.unknowns->nodes) {
    for (const int i : {first, first + 1}) {
      const double force = std::abs(s.residual[i]);
      unbalanced = std::isfinite(force) ? std::max(unbalanced, force - s.uncertain[i]) : force;
      if (!std::isfinite(unbalanced)) return unbalanced;
    }
  }
  return unbalanced;
}

/// Mean displacement and deformation gradient F = R (I + E) of the triangles, and their rates, as those of the block.
void Solid::follow_triangles() {
  if (parts_.nodes == 0) return;
  for (std::size_t b = 0; b < described(); ++b) {
    if (!blocks_[b].meshed) continue;
    Point moved = Point::Zero();
    Point velocity = Point::Zero();
    Eigen::Matrix2d F = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d F_rate = Eigen::Matrix2d::Zero();
    for (const int part : parts_.triangles[b]) {
      const BlockState& state = states_[at(part)];
      const double share = blocks_[at(part)].area / blocks_[b].area;
      moved += share * state.displacement.head<2>();
      F += share * rotation(state.displacement[2]) * stretch(state.displacement);
      const Vector6 rates = this->velocity(at(part));
      velocity += share * rates.head<2>();
      F_rate += share * rotation(state.displacement[2]) *
                (rates[2] * quarter_turn * stretch(state.displacement) + strain_of(rates));
    }
    Vector6& d = states_[b].displacement;
    const double turned = std::atan2(F(1, 0) - F(0, 1), F(0, 0) + F(1, 1));
    const double turn = d[2] + std::remainder(turned - d[2], 2 * std::numbers::pi);
    const Eigen::Matrix2d U = rotation(-turn) * F;
    const Eigen::Matrix2d U_rate = rotation(-turn) * F_rate;
    const double spin = (U_rate(1, 0) - U_rate(0, 1)) / U.trace();
    const Eigen::Matrix2d strain_rate = U_rate - spin * quarter_turn * U;
    d << moved, turn, U(0, 0) - 1, U(1, 1) - 1, U(0, 1) + U(1, 0);
    states_[b].velocity << velocity, spin, strain_rate(0, 0), strain_rate(1, 1), strain_rate(0, 1) + strain_rate(1, 0);
    start_[b] = Placement(blocks_[b].centroid, d);
  }
}

}  // namespace blockweir::solid
