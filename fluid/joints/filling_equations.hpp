// SPDX-License-Identifier: GPL-3.0-or-later
// The balance of water at each node of a network that may run dry, as equations in one unknown u a node: its pressure
// where u >= 0, and where u < 0 the share that is filled, S = 1 + u/unit. What flows has the saturation of the node
// that it comes from; a node that seeps into air gives nothing back.
#pragma once

#include <Eigen/Sparse>
#include <vector>

#include "fluid/joints/filling_factor.hpp"
#include "fluid/joints/network.hpp"

namespace blockweir::joints {

class FillingEquations {
 public:
  /// Unknowns are the nodes that are fed and not held.
  FillingEquations(const Network& network, const std::vector<bool>& fed, const WaterProperties& water);

  /// Adds storage: what is stored at a node is to change from `stored_m2` to that of u within `step_s`. A node whose
  /// walls yield by `yield_m2_per_pa` takes in that much more as its pressure rises from `before_pa`; empty: none does.
  void store(double step_s, const std::vector<double>& stored_m2, const std::vector<double>& yield_m2_per_pa,
             const std::vector<double>& before_pa);

  [[nodiscard]] Eigen::VectorXd unknowns(const Filling& filling) const;
  void take(const Eigen::VectorXd& u, Filling& filling) const;
  /// Finds u from this guess on: Newton's method, in which no node passes from full to part-filled or back in more than
  /// one step. The kept factor, of these equations or of some that were a little other, is tried first. False where it
  /// does not converge.
  bool solve(Eigen::VectorXd& u, FillingFactor& kept);

  /// Volume stored at each node [m2], at pressure 0.
  [[nodiscard]] std::vector<double> stored(const Filling& filling) const;
  /// Through each channel.
  [[nodiscard]] std::vector<double> flows(const Filling& filling) const;

 private:
  /// A node's water, and its slopes with u.
  struct State {
    double pressure = 0;
    double saturation = 1;
    double pressure_slope = 0;
    double saturation_slope = 0;
  };
  struct Flow {
    double value = 0;
    double conductance = 0;
    std::array<double, 2> slope{};
  };
  [[nodiscard]] State state(int node, const Eigen::VectorXd& u) const;
  [[nodiscard]] Flow flow(const Channel& channel, const State& from, const State& to) const;
  /// Outflow of each node; with its matrix where that is asked for.
  enum class Need { outflow, matrix };
  void assemble(const Eigen::VectorXd& u, Need need);
  bool solve_with(FillingFactor& kept, Eigen::VectorXd& u);
  void add_storage(const std::vector<State>& states, Need need);
  /// The largest outflow over what of it is round-off.
  [[nodiscard]] double imbalance() const;
  void limit(const Eigen::VectorXd& u, Eigen::VectorXd& change) const;

  const Network& network_;
  WaterProperties water_;
  double unit_pa_ = 1;
  std::vector<int> unknown_;
  std::vector<int> node_of_;
  double step_s_ = 0;  ///< 0: steady
  std::vector<double> stored_before_;
  std::vector<double> yield_m2_per_pa_;
  std::vector<double> before_pa_;
  Eigen::VectorXd outflow_;
  Eigen::VectorXd terms_;  ///< of which it is the sum, were pressures as high as they get
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace blockweir::joints
