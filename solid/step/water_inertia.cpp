// SPDX-License-Identifier: GPL-3.0-or-later
// The added-mass guard in a step. On a block of its own it is a few terms more of its matrix. A block with a mesh tells
// the fluid its mean motion; the water's inertia resists that motion, P velocities of the nodes, and so adds P^T M_a P
// to their matrix: of rank three, and of all nodes with each other. It is kept apart of the sparse matrix (Woodbury).
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

void Solid::begin_window(const Answered& answered) {
  const bool guards = scene_.coupling.added_mass_guard && scene_.analysis.kind == scene::AnalysisKind::dynamic;
  if (!guard_.acts() && (answered.masses.empty() || !guards)) return;
  guard_.begin_window(guards ? answered.masses : AddedMasses{}, answered.velocities, answered.time_s);
  mean_motions_.clear();
  matrices_dt_ = -1;
}

/// The force M_a a' on blocks and meshes, and what the inertia of meshes remembers.
void Solid::guard(double dt) {
  mean_motions_.clear();
  for (std::size_t b = 0; b < guard_.blocks(); ++b) {
    if (blocks_[b].fixed) continue;
    if (blocks_[b].meshed) {
      guard_mesh(b, dt);
    } else {
      external_[b].head<3>() += guard_.force(b);
    }
  }
}

/// P as follow_triangles() has it, at the start of the step: mean velocity of the triangles, and the turn in their mean
/// rate of deformation.
void Solid::guard_mesh(std::size_t b, double dt) {
  if (guard_.mass(b).isZero(0)) return;
  MeanMotion& mean = mean_motions_.emplace_back();
  mean.block = b;
  BlockState rates;
  const double stretch = 2 + start_[b].strain()[0] + start_[b].strain()[1];
  for (const int t : parts_.triangles[b]) {
    const Block& triangle = blocks_[at(t)];
    const auto& X = triangle.vertices;
    const double share = triangle.area / blocks_[b].area;
    auto& P = mean.of_corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point gradient = perpendicular(X[(i + 2) % 3] - X[(i + 1) % 3]) / (2 * triangle.area);
      const auto column = static_cast<Eigen::Index>(2 * i);
      P.block<2, 2>(0, column) = share / 3 * Eigen::Matrix2d::Identity();
      P.block<1, 2>(2, column) = share / stretch * start_[b].turn(perpendicular(gradient)).transpose();
    }
    rates.velocity.head<3>() += P * states_[at(t)].velocity;
    rates.acceleration.head<3>() += P * states_[at(t)].acceleration;
    external_[at(t)] += corner_shape(triangle, start_[at(t)]).transpose() * (P.transpose() * guard_.force(b));
  }
  Matrix6 added = Matrix6::Zero();
  added.topLeftCorner<3, 3>() = guard_.mass(b);
  mean.history = newmark_.history(added, rates, dt).head<3>();
}

/// By how much the kinetic energy of the water that blocks push along has risen in the step [J per metre].
double Solid::taken_by_water(const IslandSystem& s) const {
  double rise = 0;
  const auto add = [&](std::size_t b, const Eigen::Vector3d& began, const Eigen::Vector3d& ends) {
    rise += (ends - began).dot(guard_.mass(b) * (ends + began)) / 2;
  };
  for (const int b : s.island.blocks) {
    if (at(b) < guard_.blocks()) add(at(b), began_with_[at(b)].head<3>(), states_[at(b)].velocity.head<3>());
  }
  for (const MeanMotion& mean : mean_motions_) {
    if (!mean.in(parts_, s.island)) continue;
    Eigen::Vector3d began = Eigen::Vector3d::Zero();
    Eigen::Vector3d ends = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < mean.of_corners.size(); ++k) {
      const auto t = at(parts_.triangles[mean.block][k]);
      began += mean.of_corners[k] * began_with_[t];
      ends += mean.of_corners[k] * states_[t].velocity;
    }
    add(mean.block, began, ends);
  }
  return rise;
}

bool Solid::MeanMotion::in(const Parts& parts, const Island& island) const {
  return std::binary_search(island.blocks.begin(), island.blocks.end(), parts.triangles[block].front());
}

/// To the residual at nodes, and to what round-off leaves uncertain of it.
void Solid::add_mean_inertia(IslandSystem& s) {
  for (const MeanMotion& mean : mean_motions_) {
    if (!mean.in(parts_, s.island)) continue;
    const auto& triangles = parts_.triangles[mean.block];
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      moved += mean.of_corners[k] * corner_increment(at(triangles[k]));
    }
    const Eigen::Vector3d pull = newmark_.mass_factor(matrices_dt_) * (guard_.mass(mean.block) * moved);
    const Eigen::Vector3d noise = sum_round_off * (pull.cwiseAbs() + mean.history.cwiseAbs());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& nodes = s.unknowns->of(local_[at(triangles[k])]);
      s.residual(nodes) += mean.of_corners[k].transpose() * (mean.history - pull);
      s.uncertain(nodes) += mean.of_corners[k].cwiseAbs().transpose() * noise;
    }
  }
}

/// Columns P^T of all meshes in the island, and their inertia in the step's matrix, block by block.
Eigen::MatrixXd Solid::mean_motions(const IslandSystem& s, Eigen::MatrixXd& inertia) const {
  std::vector<const MeanMotion*> here;
  for (const MeanMotion& mean : mean_motions_) {
    if (mean.in(parts_, s.island)) here.push_back(&mean);
  }
  const auto count = static_cast<Eigen::Index>(3 * here.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(s.unknowns->total, count);
  inertia.setZero(count, count);
  for (std::size_t m = 0; m < here.size(); ++m) {
    const auto first = static_cast<Eigen::Index>(3 * m);
    inertia.block<3, 3>(first, first) = newmark_.mass_factor(matrices_dt_) * guard_.mass(here[m]->block);
    const auto& triangles = parts_.triangles[here[m]->block];
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& nodes = s.unknowns->of(local_[at(triangles[k])]);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        columns.block<1, 3>(nodes[i], first) += here[m]->of_corners[k].col(static_cast<Eigen::Index>(i)).transpose();
      }
    }
  }
  return columns;
}

bool Solid::solve(IslandSystem& s, bool symmetric) const {
  if (!scene_.analysis.reuse_factors) s.system->forget_factors();
  if (!s.system->solve(symmetric, s.residual, s.correction)) return false;
  with_mean_inertia(s, s.correction);
  return s.correction.allFinite();
}

/// For another force, with the matrix of the last solution.
Eigen::VectorXd Solid::solve_again(IslandSystem& s, const Eigen::VectorXd& force) const {
  Eigen::VectorXd d = s.system->solve_again(force);
  with_mean_inertia(s, d);
  return d;
}

/// (K + U S U^T) d = r from solutions with K: d = x - X (I + S U^T X)^-1 S U^T x, x = K^-1 r, X = K^-1 U.
void Solid::with_mean_inertia(const IslandSystem& s, Eigen::VectorXd& x) const {
  if (mean_motions_.empty()) return;
  Eigen::MatrixXd S;
  const Eigen::MatrixXd U = mean_motions(s, S);
  if (U.cols() == 0) return;
  Eigen::MatrixXd X(U.rows(), U.cols());
  for (Eigen::Index i = 0; i < U.cols(); ++i) X.col(i) = s.system->solve_again(U.col(i));
  const Eigen::MatrixXd core = Eigen::MatrixXd::Identity(U.cols(), U.cols()) + S * (U.transpose() * X);
  x -= X * core.partialPivLu().solve(S * (U.transpose() * x));
}

/// Beside unknown forces the inertia is a few more of them: f = lambda e.P d, a force a mode e of M_a that has inertia.
void Solid::add_mean_inertia_to_saddle(IslandSystem& s) const {
  constexpr double nothing = 1e-12;  // of the heaviest mode
  for (const MeanMotion& mean : mean_motions_) {
    if (!mean.in(parts_, s.island)) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(newmark_.mass_factor(matrices_dt_) *
                                                               guard_.mass(mean.block));
    const auto& triangles = parts_.triangles[mean.block];
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double inertia = modes.eigenvalues()[i];
      if (inertia <= nothing * modes.eigenvalues()[2]) continue;
      s.saddle.add_force(0, -1 / inertia);
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        const auto t = at(triangles[k]);
        const Vector6 along = corner_shape(blocks_[t], placement_[t]).transpose() *
                              (mean.of_corners[k].transpose() * modes.eigenvectors().col(i));
        s.saddle.couple(local_[t], -along, along);
      }
    }
  }
}

}  // namespace blockweir::solid
