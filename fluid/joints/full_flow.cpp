// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/full_flow.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <stdexcept>

#include "bridge/scene/at.hpp"
#include "fluid/joints/matrix_state.hpp"

namespace blockweir::joints {
namespace {

std::array<double, 2> apertures(const Channel& channel) {
  return {channel.aperture(0, 0), channel.aperture(1, 0)};
}

}  // namespace

struct FullFlow::Factor : Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> {};

FullFlow::FullFlow() : factor_(std::make_unique<Factor>()) {}

FullFlow::~FullFlow() = default;

std::vector<bool> fed_nodes(const Network& network) {
  std::vector<std::vector<int>> beside(network.nodes.size());
  for (const Channel& c : network.channels) {
    const auto [a, b] = apertures(c);
    if ((a <= 0 || b <= 0) && c.compliance_m_per_pa == 0) continue;
    beside[at(c.from)].push_back(c.to);
    beside[at(c.to)].push_back(c.from);
  }
  std::vector<bool> fed(network.nodes.size(), false);
  std::vector<int> open;
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    if (network.nodes[i].kind != NodeKind::held) continue;
    fed[i] = true;
    open.push_back(static_cast<int>(i));
  }
  while (!open.empty()) {
    const int from = open.back();
    open.pop_back();
    for (const int to : beside[at(from)]) {
      if (fed[at(to)]) continue;
      fed[at(to)] = true;
      open.push_back(to);
    }
  }
  return fed;
}

std::vector<double> FullFlow::pressures(const Network& network, const std::vector<bool>& fed,
                                        const WaterProperties& water) {
  std::vector<int> unknown(network.nodes.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    if (fed[i] && network.nodes[i].kind == NodeKind::inside) unknown[i] = count++;
  }
  assemble(network, fed, unknown, water);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(count);
  const bool same = unknown == pattern_ && matrix_.nonZeros() == factored_.nonZeros();
  if (count > 0 && keeps_ && same && refine(x)) {
    ++used_again_;
  } else if (count > 0) {
    factorize(/*anew=*/!same);
    pattern_ = unknown;
    x.setZero();
    refine(x);
  }
  std::vector<double> pressures(network.nodes.size(), 0.0);
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const Node& node = network.nodes[i];
    if (node.kind != NodeKind::inside) pressures[i] = node.pressure_pa;
    if (unknown[i] >= 0) pressures[i] = x[unknown[i]] - water.weight_n_per_m3 * node.height_m;
  }
  return pressures;
}

void FullFlow::assemble(const Network& network, const std::vector<bool>& fed, const std::vector<int>& unknown,
                        const WaterProperties& water) {
  const auto potential = [&](int i) {
    const Node& node = network.nodes[at(i)];
    return node.pressure_pa + water.weight_n_per_m3 * node.height_m;
  };
  const auto count = std::count_if(unknown.begin(), unknown.end(), [](int k) { return k >= 0; });
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * network.channels.size());
  links_.clear();
  for (const Channel& c : network.channels) {
    const double g = conductance(c.length_m, apertures(c), water.viscosity_pa_s).value;
    if (g == 0 || !fed[at(c.from)]) continue;
    for (const auto& [own, other] : {std::pair(c.from, c.to), std::pair(c.to, c.from)}) {
      const int row = unknown[at(own)];
      if (row < 0) continue;
      const int column = unknown[at(other)];
      entries.emplace_back(row, row, g);
      if (column >= 0) entries.emplace_back(row, column, -g);
      links_.push_back({row, column, g, column >= 0 ? 0 : potential(other)});
    }
  }
  matrix_.resize(count, count);
  matrix_.setFromTriplets(entries.begin(), entries.end());
}

/// What flows into each node: by differences of potential, which loses less than by the matrix.
Eigen::VectorXd FullFlow::inflow(const Eigen::VectorXd& x) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(x.size());
  for (const Link& l : links_) sum[l.node] += l.conductance * ((l.other >= 0 ? x[l.other] : l.potential) - x[l.node]);
  return sum;
}

void FullFlow::factorize(bool anew) {
  if (anew) factor_->analyzePattern(matrix_);
  factor_->factorize(matrix_);
  if (factor_->info() != Eigen::Success) {
    throw std::runtime_error(
        "no flow through the joints was found: the matrix of their channels has no factors; look for "
        "apertures in [joint_flow] and joints in wrong units");
  }
  factored_ = matrix_;
  ++factorizations_;
}

std::string FullFlow::state() const {
  return checkpoint::pack(pattern_, matrix_state(factored_), factorizations_, used_again_);
}

void FullFlow::restore(const std::string& state) {
  std::string matrix;
  long factorizations = 0;
  checkpoint::unpack(state, pattern_, matrix, factorizations, used_again_);
  matrix_ = matrix_of(matrix);
  if (matrix_.rows() > 0) factorize(/*anew=*/true);
  factorizations_ = factorizations;
}

/// With the factor that is there, of this matrix or of one a little other: false where that would take long.
bool FullFlow::refine(Eigen::VectorXd& x) const {
  constexpr int most = 12;
  constexpr double exact = 1e-15;
  constexpr double good = 1e-12;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most; ++i) {
    const Eigen::VectorXd change = factor_->solve(inflow(x));
    const double now = change.lpNorm<Eigen::Infinity>();
    const double size = x.lpNorm<Eigen::Infinity>();
    if (i > 0 && now > 0.3 * before) return before <= good * size;
    x += change;
    if (now <= exact * size) return true;
    before = now;
  }
  return before <= good * x.lpNorm<Eigen::Infinity>();
}

}  // namespace blockweir::joints
