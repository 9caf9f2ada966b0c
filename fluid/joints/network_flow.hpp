// SPDX-License-Identifier: GPL-3.0-or-later
// Flow through a network of joints: at each node inside, what comes in goes out or is stored,
//   d(V S (1 + p/K_w))/dt + sum of q = 0,   p >= 0,  p > 0 only where S = 1,
// with V the volume of the channels' halves at the node and q by the cubic law, times the saturation S of the node that
// it comes from. Steady flow has no first term. Where all is full and nothing widens the equations are linear.
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

  /// `filling`, empty or of the same nodes, is where the search begins. Parts that no held node feeds are dry.
  /// Throws std::runtime_error where no flow is found.
  void steady(const Network& network, Filling& filling);
  /// A step by backward Euler, of all nodes: what was fed before still has its water. `filling` is that at its begin;
  /// `stored_m2` by node is what was stored then (volume at pressure 0), and is at its end what is stored.
  /// `yield_m2_per_pa`, by node or empty: how much more a node takes in as a rising pressure moves its walls, which
  /// whoever tells their positions does not know yet.
  void step(const Network& network, double step_s, const std::vector<double>& yield_m2_per_pa, Filling& filling,
            std::vector<double>& stored_m2);
  /// Volume of water by node [m2], at pressure 0.
  [[nodiscard]] std::vector<double> stored(const Network& network, const Filling& filling) const;

  /// Whether a factor serves again while the network changes little; else each solution makes its own.
  void keep_factors(bool keeps);
  [[nodiscard]] long factorizations() const { return full_.factorizations() + factor_.count(); }
  [[nodiscard]] long kept() const { return full_.kept() + factor_.kept(); }  ///< solutions by a factor of one before
  /// Factors that it keeps, for a checkpoint: restored, it goes on with the same bits.
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

 private:
  [[nodiscard]] bool settle(const Network& network, FillingEquations& equations, Filling& filling, Eigen::VectorXd& u);
  void fill(const Network& network, const std::vector<bool>& fed, Filling& filling);

  WaterProperties water_;
  FullFlow full_;
  FillingFactor factor_;
};

/// What flows out of a network at its nodes of a kind, less what flows in [m2/s].
double outflow(const Network& network, const Filling& filling, NodeKind kind);

}  // namespace blockweir::joints
