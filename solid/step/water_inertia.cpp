// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/water_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"
#include "solid/step/island_equations.hpp"

namespace blockweir::solid {

void WaterInertia::begin_window(const Answered& answered) {
  const bool guards = model_.scene.coupling.added_mass_guard && model_.is(scene::AnalysisKind::dynamic);
  if (!state_.guard.acts() && (answered.masses.empty() || !guards)) return;
  state_.guard.begin_window(guards ? answered.masses : AddedMasses{}, answered.velocities, answered.time_s);
  mean_motions_.clear();
  trial_.dt = -1;
}

void WaterInertia::begin_step(double dt) {
  mean_motions_.clear();
  for (std::size_t b = 0; b < state_.guard.blocks(); ++b) {
    if (model_.blocks[b].fixed) continue;
    if (model_.blocks[b].meshed) {
      guard_mesh(b, dt);
    } else {
      trial_.external[b].head<3>() += state_.guard.force(b);
    }
  }
}

/// P as follow_triangles() has it, at the start of the step: mean velocity of the triangles, and the turn in their mean
/// rate of deformation.
void WaterInertia::guard_mesh(std::size_t b, double dt) {
  if (state_.guard.mass(b).isZero(0)) return;
  MeanMotion& mean = mean_motions_.emplace_back();
  mean.block = b;
  BlockState rates;
  const double stretch = 2 + state_.placements[b].strain()[0] + state_.placements[b].strain()[1];
  for (const int t : model_.parts.triangles[b]) {
    const Block& triangle = model_.blocks[at(t)];
    const auto& X = triangle.vertices;
    const double share = triangle.area / model_.blocks[b].area;
    auto& P = mean.of_corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point gradient = perpendicular(X[(i + 2) % 3] - X[(i + 1) % 3]) / (2 * triangle.area);
      const auto column = static_cast<Eigen::Index>(2 * i);
      P.block<2, 2>(0, column) = share / 3 * Eigen::Matrix2d::Identity();
      P.block<1, 2>(2, column) = share / stretch * state_.placements[b].turn(perpendicular(gradient)).transpose();
    }
    rates.velocity.head<3>() += P * state_.blocks[at(t)].velocity;
    rates.acceleration.head<3>() += P * state_.blocks[at(t)].acceleration;
    trial_.external[at(t)] +=
        corner_shape(triangle, state_.placements[at(t)]).transpose() * (P.transpose() * state_.guard.force(b));
  }
  Matrix6 added = Matrix6::Zero();
  added.topLeftCorner<3, 3>() = state_.guard.mass(b);
  mean.history = trial_.scheme.history(added, rates, dt).head<3>();
}

double WaterInertia::taken_by_water(const IslandEquations& s) const {
  double rise = 0;
  const auto add = [&](std::size_t b, const Eigen::Vector3d& began, const Eigen::Vector3d& ends) {
    rise += (ends - began).dot(state_.guard.mass(b) * (ends + began)) / 2;
  };
  for (const int b : s.island.blocks) {
    if (at(b) < state_.guard.blocks())
      add(at(b), trial_.began_with[at(b)].head<3>(), state_.blocks[at(b)].velocity.head<3>());
  }
  for (const MeanMotion& mean : mean_motions_) {
    if (!mean.in(model_.parts, s.island)) continue;
    Eigen::Vector3d began = Eigen::Vector3d::Zero();
    Eigen::Vector3d ends = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < mean.of_corners.size(); ++k) {
      const auto t = at(model_.parts.triangles[mean.block][k]);
      began += mean.of_corners[k] * trial_.began_with[t];
      ends += mean.of_corners[k] * state_.blocks[t].velocity;
    }
    add(mean.block, began, ends);
  }
  return rise;
}

bool WaterInertia::MeanMotion::in(const Parts& parts, const Island& island) const {
  return std::binary_search(island.blocks.begin(), island.blocks.end(), parts.triangles[block].front());
}

void WaterInertia::add_to_residual(IslandEquations& s) const {
  for (const MeanMotion& mean : mean_motions_) {
    if (!mean.in(model_.parts, s.island)) continue;
    const auto& triangles = model_.parts.triangles[mean.block];
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      moved += mean.of_corners[k] * trial_.corner_increment(at(triangles[k]));
    }
    const Eigen::Vector3d pull = trial_.scheme.mass_factor(trial_.dt) * (state_.guard.mass(mean.block) * moved);
    const Eigen::Vector3d noise = sum_round_off * (pull.cwiseAbs() + mean.history.cwiseAbs());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& nodes = s.unknowns->of(s.local(triangles[k]));
      s.residual(nodes) += mean.of_corners[k].transpose() * (mean.history - pull);
      s.uncertain(nodes) += mean.of_corners[k].cwiseAbs().transpose() * noise;
    }
  }
}

/// Columns P^T of all meshes in the island, and their inertia in the step's matrix, block by block.
Eigen::MatrixXd WaterInertia::mean_motions(const IslandEquations& s, Eigen::MatrixXd& inertia) const {
  std::vector<const MeanMotion*> here;
  for (const MeanMotion& mean : mean_motions_) {
    if (mean.in(model_.parts, s.island)) here.push_back(&mean);
  }
  const auto count = static_cast<Eigen::Index>(3 * here.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(s.unknowns->total, count);
  inertia.setZero(count, count);
  for (std::size_t m = 0; m < here.size(); ++m) {
    const auto first = static_cast<Eigen::Index>(3 * m);
    inertia.block<3, 3>(first, first) = trial_.scheme.mass_factor(trial_.dt) * state_.guard.mass(here[m]->block);
    const auto& triangles = model_.parts.triangles[here[m]->block];
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& nodes = s.unknowns->of(s.local(triangles[k]));
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        columns.block<1, 3>(nodes[i], first) += here[m]->of_corners[k].col(static_cast<Eigen::Index>(i)).transpose();
      }
    }
  }
  return columns;
}

void WaterInertia::correct(const IslandEquations& s, Eigen::VectorXd& x) const {
  if (mean_motions_.empty()) return;
  Eigen::MatrixXd S;
  const Eigen::MatrixXd U = mean_motions(s, S);
  if (U.cols() == 0) return;
  Eigen::MatrixXd X(U.rows(), U.cols());
  for (Eigen::Index i = 0; i < U.cols(); ++i) X.col(i) = s.system().solve_again(U.col(i));
  const Eigen::MatrixXd core = Eigen::MatrixXd::Identity(U.cols(), U.cols()) + S * (U.transpose() * X);
  x -= X * core.partialPivLu().solve(S * (U.transpose() * x));
}

void WaterInertia::add_to_saddle(const IslandEquations& s, SaddlePoint& saddle) const {
  constexpr double nothing = 1e-12;  // of the heaviest mode
  for (const MeanMotion& mean : mean_motions_) {
    if (!mean.in(model_.parts, s.island)) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(trial_.scheme.mass_factor(trial_.dt) *
                                                               state_.guard.mass(mean.block));
    const auto& triangles = model_.parts.triangles[mean.block];
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double inertia = modes.eigenvalues()[i];
      if (inertia <= nothing * modes.eigenvalues()[2]) continue;
      saddle.add_force(0, -1 / inertia);
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        const auto t = at(triangles[k]);
        const Vector6 along = corner_shape(model_.blocks[t], trial_.placement[t]).transpose() *
                              (mean.of_corners[k].transpose() * modes.eigenvectors().col(i));
        saddle.couple(s.local(static_cast<int>(t)), -along, along);
      }
    }
  }
}

}  // namespace blockweir::solid
