// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/pressure_equation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

constexpr double sdirk2 = 1 - 1 / std::numbers::sqrt2;  ///< b over the window

}  // namespace

PressureEquation::PressureEquation(const WaterMesh& mesh, const WaterPhysics& physics, const std::vector<bool>& ground,
                                   double window_s)
    : mesh_(mesh),
      physics_(physics),
      ground_(ground),
      density_(physics.density_kg_per_m3),
      remembers_(physics.remembers()),
      theta_(physics.theta),
      window_s_(window_s),
      unknowns_(unknowns_of(mesh, std::isfinite(physics.gravity_m_per_s2))) {
  if (!remembers_) stiffness_.emplace(mesh, unknowns_);
  const Eigen::SparseMatrix<double>& first = matrix();
  factors_.emplace(first);
  factorize(first);
}

void PressureEquation::update(double window_s) {
  window_s_ = window_s;
  factorize(matrix());
}

const Eigen::SparseMatrix<double>& PressureEquation::matrix() {
  if (stiffness_) return stiffness_->of(mesh_);
  matrices_ = matrices_of(mesh_, unknowns_, physics_, ground_);
  const double b = theta_.value_or(sdirk2) * window_s_;
  of_stages_ = matrices_.K + matrices_.C / b + matrices_.M / (b * b);
  return of_stages_;
}

void PressureEquation::factorize(const Eigen::SparseMatrix<double>& matrix) {
  if (!factors_->factorize(matrix)) {
    throw std::runtime_error(
        "the pressures of the reservoir are not determined; expected a free surface on each body of "
        "water; lower its level, or move its wall off");
  }
}

Eigen::VectorXd PressureEquation::flux(const Moves& moves, const Acceleration& acceleration) const {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh_.node.size()));
  const Eigen::Matrix3d mass = side_mass();
  for (const BoundarySide& side : mesh_.side) {
    if (!moves(side)) continue;
    const Point span = mesh_.node[at(side.node[2])] - mesh_.node[at(side.node[0])];
    const Point normal(span.y(), -span.x());  // out of the water, of the side's length
    Eigen::Vector3d along;
    for (Eigen::Index i = 0; i < 3; ++i) {
      along[i] = acceleration(mesh_.node[at(side.node[static_cast<std::size_t>(i)])]).dot(normal);
    }
    const Eigen::Vector3d share = mass * along;
    for (Eigen::Index i = 0; i < 3; ++i) g[side.node[static_cast<std::size_t>(i)]] += share[i];
  }
  return g;
}

PressureState PressureEquation::rest() const {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh_.node.size()));
  return {none, none, none};
}

void PressureEquation::step(PressureState& state, const Eigen::VectorXd& flux) const {
  const Eigen::VectorXd f = -density_ * at_unknowns(flux);
  if (!remembers_) {
    state.p = at_nodes(factors_->solve(f));
    return;
  }
  const double b = theta_.value_or(sdirk2) * window_s_;
  const Eigen::VectorXd p0 = at_unknowns(state.p);
  const Eigen::VectorXd v0 = at_unknowns(state.rate);
  Eigen::VectorXd p;
  Eigen::VectorXd v;
  // The end of a stage that begins, but for b times the rates of its end, with p_from and v_from.
  const auto finish = [&](const Eigen::VectorXd& p_from, const Eigen::VectorXd& v_from) {
    const Eigen::VectorXd damped = matrices_.C.selfadjointView<Eigen::Lower>() * p_from;
    const Eigen::VectorXd inert = matrices_.M.selfadjointView<Eigen::Lower>() * (p_from / b + v_from);
    p = factors_->solve(f + (damped + inert) / b);
    v = (p - p_from) / b;
  };
  finish(p0, v0);
  if (theta_) {
    state.p = at_nodes(p0 + (p - p0) / *theta_);
    state.rate = at_nodes(v0 + (v - v0) / *theta_);
    return;
  }
  const double rest = window_s_ - b;
  finish(p0 + rest * v, v0 + rest * (v - v0) / b);
  state.p = at_nodes(p);
  state.rate = at_nodes(v);
}

Eigen::VectorXd PressureEquation::pressure(const Eigen::VectorXd& flux) const {
  PressureState state = rest();
  step(state, flux);
  return state.p;
}

void PressureEquation::solve(const Eigen::SparseMatrix<double>& flux, const Take& take) const {
  if (remembers_) {
    for (Eigen::Index k = 0; k < flux.cols(); ++k) take(k, pressure(flux.col(k)));
    return;
  }
  std::vector<int> wanted;  // nodes of faces
  std::vector<bool> seen(mesh_.node.size(), false);
  for (const BoundarySide& side : mesh_.side) {
    if (side.kind != BoundarySide::Kind::face) continue;
    for (const int node : side.node) {
      if (unknowns_.of_node[at(node)] >= 0 && !seen[at(node)]) wanted.push_back(node);
      seen[at(node)] = true;
    }
  }
  std::vector<int> unknowns(wanted.size());
  std::transform(wanted.begin(), wanted.end(), unknowns.begin(), [&](int node) { return unknowns_.of_node[at(node)]; });
  Eigen::MatrixXd p;
  factors_->solve(-density_ * at_unknowns(flux), unknowns, [&](Eigen::Index first, const Eigen::MatrixXd& x) {
    if (p.cols() != x.cols()) p.setZero(flux.rows(), x.cols());
    for (std::size_t i = 0; i < wanted.size(); ++i) p.row(wanted[i]) = x.row(static_cast<Eigen::Index>(i));
    take(first, p);
  });
}

Eigen::MatrixXd PressureEquation::added_mass(const Eigen::SparseMatrix<double>& flux) const {
  if (!remembers_) return density_ * factors_->flexibility(at_unknowns(flux));
  Eigen::MatrixXd work(flux.cols(), flux.cols());
  solve(flux,
        [&](Eigen::Index first, const Eigen::MatrixXd& p) { work.middleCols(first, p.cols()) = flux.transpose() * p; });
  return -(work + work.transpose()) / 2;
}

/// What a unit of each pressure lifts.
Eigen::VectorXd PressureEquation::lifts() const {
  return matrices_.M.selfadjointView<Eigen::Lower>() * Eigen::VectorXd::Ones(unknowns_.count);
}

LiftedWater PressureEquation::lifted(const PressureState& state) const {
  if (!std::isfinite(physics_.gravity_m_per_s2)) return {};
  const Eigen::VectorXd share = lifts();
  return {share.dot(at_unknowns(state.p)), share.dot(at_unknowns(state.rate))};
}

void PressureEquation::keep(const LiftedWater& lifted, PressureState& state) const {
  if (!std::isfinite(physics_.gravity_m_per_s2)) return;
  const LiftedWater now = this->lifted(state);
  const double of_all = lifts().sum();
  state.p.array() += (lifted.amount - now.amount) / of_all;
  state.loaded.array() += (lifted.amount - now.amount) / of_all;
  state.rate.array() += (lifted.rate - now.rate) / of_all;
}

Eigen::VectorXd PressureEquation::at_unknowns(const Eigen::VectorXd& at_nodes) const {
  Eigen::VectorXd values(unknowns_.count);
  for (std::size_t i = 0; i < unknowns_.of_node.size(); ++i) {
    if (unknowns_.of_node[i] >= 0) values[unknowns_.of_node[i]] = at_nodes[static_cast<Eigen::Index>(i)];
  }
  return values;
}

Eigen::SparseMatrix<double> PressureEquation::at_unknowns(const Eigen::SparseMatrix<double>& at_nodes) const {
  Eigen::SparseMatrix<double> values(unknowns_.count, at_nodes.cols());
  values.reserve(at_nodes.nonZeros());
  for (Eigen::Index k = 0; k < at_nodes.cols(); ++k) {
    values.startVec(k);
    for (Eigen::SparseMatrix<double>::InnerIterator a(at_nodes, k); a; ++a) {
      const int unknown = unknowns_.of_node[at(static_cast<int>(a.row()))];
      if (unknown >= 0) values.insertBack(unknown, k) = a.value();  // nodes and their unknowns are in the same order
    }
  }
  values.finalize();
  return values;
}

Eigen::VectorXd PressureEquation::at_nodes(const Eigen::VectorXd& at_unknowns) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_.of_node.size()));
  for (std::size_t i = 0; i < unknowns_.of_node.size(); ++i) {
    if (unknowns_.of_node[i] >= 0) values[static_cast<Eigen::Index>(i)] = at_unknowns[unknowns_.of_node[i]];
  }
  return values;
}

}  // namespace blockweir::reservoir
