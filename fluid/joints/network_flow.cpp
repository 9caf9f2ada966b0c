// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/network_flow.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::joints {
namespace {

bool widens(const Network& network) {
  return std::any_of(network.channels.begin(), network.channels.end(),
                     [](const Channel& c) { return c.compliance_m_per_pa > 0; });
}

/// Out of each node into the network.
std::vector<double> supplies(const Network& network, const std::vector<double>& flow) {
  std::vector<double> supply(network.nodes.size(), 0.0);
  for (std::size_t c = 0; c < flow.size(); ++c) {
    supply[at(network.channels[c].from)] += flow[c];
    supply[at(network.channels[c].to)] -= flow[c];
  }
  return supply;
}

/// Outflow into air at each node: inflow, less onward flow and storage in a step.
std::vector<double> running_out(const Network& network, const std::vector<double>& flow,
                                const std::vector<double>& stored_per_s) {
  std::vector<double> out = supplies(network, flow);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double stored = stored_per_s.empty() ? 0 : stored_per_s[i];
    out[i] = network.nodes[i].kind == NodeKind::seeps ? -out[i] - stored : 0;
  }
  return out;
}

/// Does water hang nowhere, and come in nowhere out of air?
bool holds(const Network& network, const Filling& filling, double weight_n_per_m3) {
  double most_pa = 0;
  double most_flow = 0;
  for (const double p : filling.pressure_pa) most_pa = std::max(most_pa, p);
  for (const double q : filling.flow) most_flow = std::max(most_flow, std::abs(q));
  constexpr double round_off = 1e-13;
  const std::vector<double> supply = supplies(network, filling.flow);
  for (std::size_t i = 0; i < supply.size(); ++i) {
    const Node& node = network.nodes[i];
    const double round_off_pa = round_off * (most_pa + weight_n_per_m3 * std::abs(node.height_m));
    if (node.kind == NodeKind::inside && filling.pressure_pa[i] < -round_off_pa) return false;
    if (node.kind == NodeKind::seeps && supply[i] > round_off * most_flow) return false;
  }
  return true;
}

}  // namespace

/// The first guess: all of it full.
void NetworkFlow::fill(const Network& network, const std::vector<bool>& fed, Filling& filling) {
  filling.pressure_pa = full_.pressures(network, fed, water_);
  filling.saturation.assign(network.nodes.size(), 1.0);
  for (std::size_t i = 0; i < fed.size(); ++i) {
    if (!fed[i]) filling.saturation[i] = 0;
  }
}

void NetworkFlow::steady(const Network& network, Filling& filling) {
  const std::vector<bool> fed = fed_nodes(network);
  FillingEquations equations(network, fed, water_);
  const bool begins = filling.pressure_pa.size() != network.nodes.size();
  // What was partly dry most likely is so again.
  bool was_full = true;
  for (std::size_t i = 0; !begins && i < fed.size(); ++i) {
    was_full = was_full && (network.nodes[i].kind == NodeKind::held || !fed[i] || filling.saturation[i] >= 1);
  }
  if (was_full && !widens(network)) {
    Filling full;
    fill(network, fed, full);
    full.flow = equations.flows(full);
    if (holds(network, full, water_.weight_n_per_m3)) {
      for (double& p : full.pressure_pa) p = std::max(0.0, p);
      full.to_air = running_out(network, full.flow, {});
      filling = std::move(full);
      return;
    }
    if (begins) filling = std::move(full);
  } else if (begins) {
    fill(network, fed, filling);
  }
  Eigen::VectorXd u = equations.unknowns(filling);
  if (!equations.solve(u, factor_) && !settle(network, equations, filling, u)) {
    throw std::runtime_error(
        "no steady flow through the joints was found: it opens and closes them without an end; \"blockweir run\" "
        "follows it with kind = \"transient\" in [joint_flow]; level and safety take the flow as steady: ask for "
        "another level, or state another uplift");
  }
  equations.take(u, filling);
  filling.flow = equations.flows(filling);
  filling.to_air = running_out(network, filling.flow, {});
}

void NetworkFlow::keep_factors(bool keeps) {
  full_.keep_factors(keeps);
  factor_.keep(keeps);
}

/// Lets the water run until it is steady, by ever longer steps.
bool NetworkFlow::settle(const Network& network, FillingEquations& equations, Filling& filling, Eigen::VectorXd& u) {
  for (double& p : filling.pressure_pa) p = std::max(0.0, p);
  std::vector<double> stored_m2 = equations.stored(filling);
  constexpr double first_s = 1e-3;
  constexpr double last_s = 1e12;
  for (double step_s = first_s; step_s < last_s; step_s *= 4) {
    if (!try_step(network, step_s, {}, filling, stored_m2)) return false;
    u = equations.unknowns(filling);
    if (equations.solve(u, factor_)) return true;
  }
  return false;
}

std::string NetworkFlow::state() const {
  return checkpoint::pack(full_.state(), factor_.state());
}

void NetworkFlow::restore(const std::string& state) {
  std::string full;
  std::string factor;
  checkpoint::unpack(state, full, factor);
  full_.restore(full);
  factor_.restore(factor);
}

void NetworkFlow::step(const Network& network, double step_s, const std::vector<double>& yield_m2_per_pa,
                       Filling& filling, std::vector<double>& stored_m2) {
  if (!try_step(network, step_s, yield_m2_per_pa, filling, stored_m2)) {
    throw std::runtime_error(
        "no flow through the joints was found, even in shares of a window; lower [coupling] window_s");
  }
}

bool NetworkFlow::try_step(const Network& network, double step_s, const std::vector<double>& yield_m2_per_pa,
                           Filling& filling, std::vector<double>& stored_m2) {
  const std::vector<bool> all(network.nodes.size(), true);  // what no pool feeds any more drains slowly
  constexpr double shortest = 1.0 / 1024;
  double share = 1;  // of the step; a sudden change takes shorter ones
  std::vector<double> flow(network.channels.size(), 0.0);
  const std::vector<double> stored_before = stored_m2;
  for (double done = 0; done < 1;) {
    FillingEquations equations(network, all, water_);
    equations.store(share * step_s, stored_m2, yield_m2_per_pa, filling.pressure_pa);
    Eigen::VectorXd u = equations.unknowns(filling);
    if (equations.solve(u, factor_)) {
      equations.take(u, filling);
      const std::vector<double> now = equations.flows(filling);
      for (std::size_t c = 0; c < flow.size(); ++c) flow[c] += share * now[c];
      stored_m2 = equations.stored(filling);
      done += share;
      continue;
    }
    share /= 2;
    if (share < shortest) return false;
  }
  filling.flow = std::move(flow);
  std::vector<double> stored_per_s;
  for (std::size_t i = 0; i < stored_m2.size(); ++i) stored_per_s.push_back((stored_m2[i] - stored_before[i]) / step_s);
  filling.to_air = running_out(network, filling.flow, stored_per_s);
  return true;
}

std::vector<double> NetworkFlow::stored(const Network& network, const Filling& filling) const {
  return FillingEquations(network, fed_nodes(network), water_).stored(filling);
}

double outflow(const Network& network, const Filling& filling, NodeKind kind) {
  if (kind == NodeKind::seeps) return std::accumulate(filling.to_air.begin(), filling.to_air.end(), 0.0);
  const std::vector<double> supply = supplies(network, filling.flow);
  double sum = 0;
  for (std::size_t i = 0; i < supply.size(); ++i) {
    if (network.nodes[i].kind == kind) sum -= supply[i];
  }
  return sum;
}

}  // namespace blockweir::joints
