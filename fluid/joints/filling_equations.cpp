// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/filling_equations.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::joints {

FillingEquations::FillingEquations(const Network& network, const std::vector<bool>& fed, const WaterProperties& water)
    : network_(network), water_(water), unknown_(network.nodes.size(), -1) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    const Node& node = network.nodes[i];
    low = std::min(low, node.height_m);
    high = std::max(high, node.height_m);
    unit_pa_ = std::max(unit_pa_, node.pressure_pa);
    if (node.kind == NodeKind::held || !fed[i]) continue;
    unknown_[i] = static_cast<int>(node_of_.size());
    node_of_.push_back(static_cast<int>(i));
  }
  unit_pa_ = std::max(unit_pa_, water.weight_n_per_m3 * (high - low));
}

void FillingEquations::store(double step_s, const std::vector<double>& stored_m2,
                             const std::vector<double>& yield_m2_per_pa, const std::vector<double>& before_pa) {
  step_s_ = step_s;
  stored_before_ = stored_m2;
  yield_m2_per_pa_ = yield_m2_per_pa;
  before_pa_ = before_pa;
}

Eigen::VectorXd FillingEquations::unknowns(const Filling& filling) const {
  Eigen::VectorXd u(static_cast<Eigen::Index>(node_of_.size()));
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    const std::size_t i = at(node_of_[static_cast<std::size_t>(k)]);
    const bool full = filling.saturation[i] >= 1;
    u[k] = full ? std::max(0.0, filling.pressure_pa[i]) : unit_pa_ * (filling.saturation[i] - 1);
  }
  return u;
}

FillingEquations::State FillingEquations::state(int node, const Eigen::VectorXd& u) const {
  const Node& n = network_.nodes[at(node)];
  if (n.kind == NodeKind::held) return {n.pressure_pa, 1, 0, 0};
  const int k = unknown_[at(node)];
  if (k < 0) return {0, 0, 0, 0};
  if (u[k] >= 0) return n.kind == NodeKind::seeps ? State{0, 1, 0, 0} : State{u[k], 1, 1, 0};
  return {0, std::max(0.0, 1 + u[k] / unit_pa_), 0, 1 / unit_pa_};
}

void FillingEquations::take(const Eigen::VectorXd& u, Filling& filling) const {
  filling.pressure_pa.assign(network_.nodes.size(), 0.0);
  filling.saturation.assign(network_.nodes.size(), 0.0);
  for (std::size_t i = 0; i < network_.nodes.size(); ++i) {
    const State s = state(static_cast<int>(i), u);
    filling.pressure_pa[i] = s.pressure;
    filling.saturation[i] = s.saturation;
  }
}

FillingEquations::Flow FillingEquations::flow(const Channel& c, const State& from, const State& to) const {
  const std::array<double, 2> aperture = {c.aperture(0, from.pressure), c.aperture(1, to.pressure)};
  const Conductance g = conductance(c.length_m, aperture, water_.viscosity_pa_s);
  const double fall =
      from.pressure - to.pressure +
      water_.weight_n_per_m3 * (network_.nodes[at(c.from)].height_m - network_.nodes[at(c.to)].height_m);
  const State& source = fall >= 0 ? from : to;
  Flow flow;
  flow.conductance = g.value;
  flow.value = source.saturation * g.value * fall;
  const auto widens = [&](int end) {
    return c.widening(end, end == 0 ? from.pressure : to.pressure) * g.slope[at(end)] * fall;
  };
  flow.slope[0] = source.saturation * (g.value + widens(0)) * from.pressure_slope;
  flow.slope[1] = source.saturation * (widens(1) - g.value) * to.pressure_slope;
  flow.slope[fall >= 0 ? 0 : 1] += source.saturation_slope * g.value * fall;
  return flow;
}

void FillingEquations::assemble(const Eigen::VectorXd& u, Need need) {
  std::vector<State> states;
  states.reserve(network_.nodes.size());
  for (std::size_t i = 0; i < network_.nodes.size(); ++i) states.push_back(state(static_cast<int>(i), u));
  outflow_.setZero(u.size());
  terms_.setZero(u.size());
  entries_.clear();
  for (const Channel& c : network_.channels) {
    const int from = unknown_[at(c.from)];
    const int to = unknown_[at(c.to)];
    if (from < 0 && to < 0) continue;
    const Flow q = flow(c, states[at(c.from)], states[at(c.to)]);
    for (const auto& [row, sign] : {std::pair(from, 1.0), std::pair(to, -1.0)}) {
      if (row < 0) continue;
      outflow_[row] += sign * q.value;
      terms_[row] += q.conductance * unit_pa_;
      if (need == Need::outflow) continue;
      if (from >= 0) entries_.emplace_back(row, from, sign * q.slope[0]);
      if (to >= 0) entries_.emplace_back(row, to, sign * q.slope[1]);
    }
  }
  // Keeps a node that neither fills nor empties where it is.
  constexpr double firm = 1e-10;
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    terms_[k] = std::max(terms_[k], std::numeric_limits<double>::min());
    const double ease = terms_[k] / unit_pa_;
    const bool runs_out =
        u[k] >= 0 && network_.nodes[at(node_of_[static_cast<std::size_t>(k)])].kind == NodeKind::seeps;
    if (runs_out) outflow_[k] += ease * u[k];
    if (runs_out && need == Need::matrix) entries_.emplace_back(k, k, ease);
    if (need == Need::matrix) entries_.emplace_back(k, k, firm * terms_[k] / unit_pa_);
  }
  if (step_s_ > 0) add_storage(states, need);
  if (need == Need::outflow) return;
  matrix_.resize(u.size(), u.size());
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
}

double FillingEquations::imbalance() const {
  constexpr double round_off = 1e-14;
  return outflow_.size() == 0 ? 0 : (outflow_.array() / terms_.array()).abs().maxCoeff() / round_off;
}

void FillingEquations::add_storage(const std::vector<State>& states, Need need) {
  Filling filling;
  for (const State& s : states) {
    filling.pressure_pa.push_back(s.pressure);
    filling.saturation.push_back(1);
  }
  const std::vector<double> full = stored(filling);
  std::vector<double> widening(states.size(), 0.0);
  for (const Channel& c : network_.channels) {
    widening[at(c.from)] += c.length_m / 2 * c.widening(0, states[at(c.from)].pressure);
    widening[at(c.to)] += c.length_m / 2 * c.widening(1, states[at(c.to)].pressure);
  }
  for (std::size_t k = 0; k < node_of_.size(); ++k) {
    const std::size_t i = at(node_of_[k]);
    const State& s = states[i];
    const auto row = static_cast<Eigen::Index>(k);
    const double pressed = 1 + s.pressure / water_.bulk_modulus_pa;
    const double yields = yield_m2_per_pa_.empty() ? 0 : yield_m2_per_pa_[i];
    outflow_[row] += (s.saturation * full[i] - stored_before_[i]) / step_s_;
    if (yields > 0) outflow_[row] += yields * (s.pressure - before_pa_[i]) / step_s_;
    terms_[row] += (full[i] + yields * unit_pa_) / step_s_;
    if (need == Need::outflow) continue;
    const double by_pressure =
        yields + s.saturation * (widening[i] * pressed + full[i] / pressed / water_.bulk_modulus_pa);
    entries_.emplace_back(row, row, (by_pressure * s.pressure_slope + full[i] * s.saturation_slope) / step_s_);
  }
}

/// A node passes the point where it is just full by stopping there once.
void FillingEquations::limit(const Eigen::VectorXd& u, Eigen::VectorXd& change) const {
  const double just = 1e-12 * unit_pa_;
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    const double to = u[k] + change[k];
    if (u[k] >= 0 && to < 0) change[k] = -just - u[k];
    if (u[k] < 0 && to > 0) change[k] = just - u[k];
    if (to < -unit_pa_) change[k] = -unit_pa_ - u[k];
  }
}

/// Each change is that of the same matrix, which the last one was little other than: true once it has converged.
bool FillingEquations::solve_with(FillingFactor& kept, Eigen::VectorXd& u) {
  constexpr int most = 40;  // each costs a fortieth of a factor
  constexpr double least_gain = 0.95;
  for (int i = 0; i < most; ++i) {
    if (imbalance() <= 1) return true;
    const double before = outflow_.norm();
    Eigen::VectorXd change = kept.solve(-outflow_);
    limit(u, change);
    const Eigen::VectorXd from = u;
    u += change;
    assemble(u, Need::outflow);
    if (outflow_.norm() <= least_gain * before) continue;
    u = from;
    return false;
  }
  return imbalance() <= 1;
}

bool FillingEquations::solve(Eigen::VectorXd& u, FillingFactor& kept) {
  constexpr int most = 200;
  assemble(u, Need::matrix);
  if (kept.fits(matrix_) && solve_with(kept, u)) {
    kept.used_again();
    return true;
  }
  for (int i = 0; i < most; ++i) {
    assemble(u, Need::matrix);
    if (imbalance() <= 1) return true;
    if (!kept.make(matrix_)) return false;
    Eigen::VectorXd change = kept.solve(-outflow_);
    if (!change.allFinite()) return false;
    limit(u, change);
    const double before = outflow_.norm();
    const Eigen::VectorXd from = u;
    // A step that increases the residual is shortened; one that always does is accepted: it leaves a kink.
    constexpr int halvings = 6;
    double share = 1;
    for (int k = 0; k <= halvings; ++k, share /= 2) {
      u = from + (k < halvings ? share : 1) * change;
      assemble(u, Need::outflow);
      if (outflow_.norm() < before) break;
    }
    if ((u - from).lpNorm<Eigen::Infinity>() <= 1e-15 * unit_pa_) return true;
  }
  return false;
}

std::vector<double> FillingEquations::stored(const Filling& filling) const {
  std::vector<double> volume(network_.nodes.size(), 0.0);
  for (const Channel& c : network_.channels) {
    volume[at(c.from)] += c.length_m / 2 * c.aperture(0, filling.pressure_pa[at(c.from)]);
    volume[at(c.to)] += c.length_m / 2 * c.aperture(1, filling.pressure_pa[at(c.to)]);
  }
  for (std::size_t i = 0; i < volume.size(); ++i) {
    volume[i] *= filling.saturation[i] * (1 + filling.pressure_pa[i] / water_.bulk_modulus_pa);
  }
  return volume;
}

std::vector<double> FillingEquations::flows(const Filling& filling) const {
  std::vector<double> flows;
  for (const Channel& c : network_.channels) {
    const State from{filling.pressure_pa[at(c.from)], filling.saturation[at(c.from)]};
    const State to{filling.pressure_pa[at(c.to)], filling.saturation[at(c.to)]};
    flows.push_back(flow(c, from, to).value);
  }
  return flows;
}

}  // namespace blockweir::joints
