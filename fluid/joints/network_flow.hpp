// SPDX-License-Identifier: GPL-3.0-or-later
// Flow through a network of joints. At each inside node inflow equals outflow plus storage,
//   d(V S (1 + p/K_w))/dt + sum of q = 0,   p >= 0,  p > 0 only where S = 1,
// V is the volume of the channel halves at the node; q follows the cubic law times the saturation S of its upstream
// node. Steady flow has no first term. If all nodes are full and nothing widens, the equations are linear.
#pragma once

#include <string>
#include <vector>

#include "fluid/joints/filling_equations.hpp"
#include "fluid/joints/full_flow.hpp"
#include "fluid/joints/network.hpp"

namespace blockweir::joints {

class NetworkFlow {
 public:
  explicit NetworkFlow(const WaterProperties& water) : water_(water) {}

  /// `filling`, empty or for the same nodes, is the initial guess. Parts that no held node feeds are dry. Throws
  /// std::runtime_error if no flow is found.
  void steady(const Network& network, Filling& filling);
  /// One backward Euler step for all nodes: nodes that were fed before keep their water. `filling` is the state at the
  /// start; `stored_m2` is the storage of each node at the start (volume at pressure 0) and is updated.
  /// `yield_m2_per_pa`, by node or empty: additional storage as a rising pressure moves a node's walls, a motion that
  /// the given positions do not contain yet.
  void step(const Network& network, double step_s, const std::vector<double>& yield_m2_per_pa, Filling& filling,
            std::vector<double>& stored_m2);
  /// Volume of water by node [m2], at pressure 0.
  [[nodiscard]] std::vector<double> stored(const Network& network, const Filling& filling) const;

  /// Whether factorizations are reused while the network changes little; otherwise each solution makes its own.
  void keep_factors(bool keeps);
  [[nodiscard]] long factorizations() const { return full_.factorizations() + factor_.count(); }
  [[nodiscard]] long kept() const { return full_.kept() + factor_.kept(); }  ///< solutions with a reused factorization
  /// The kept factorizations, for a checkpoint: after a restart the results have the same bits.
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  /// As step(), but false if no flow is found.
  [[nodiscard]] bool try_step(const Network& network, double step_s, const std::vector<double>& yield_m2_per_pa,
                              Filling& filling, std::vector<double>& stored_m2);
  [[nodiscard]] bool settle(const Network& network, FillingEquations& equations, Filling& filling, Eigen::VectorXd& u);
  void fill(const Network& network, const std::vector<bool>& fed, Filling& filling);

  WaterProperties water_;
  FullFlow full_;
  FillingFactor factor_;
};

/// Outflow minus inflow of a network at its nodes of a kind [m2/s].
double outflow(const Network& network, const Filling& filling, NodeKind kind);

}  // namespace blockweir::joints
