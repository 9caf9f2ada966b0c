// SPDX-License-Identifier: GPL-3.0-or-later
// Water balance at each node of a network that may be partly dry, with one unknown u for each node: the pressure if u
// >= 0; if u < 0 the filled share is S = 1 + u/unit. The flow has the saturation of its upstream node; a node that
// seeps into air returns nothing.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "fluid/joints/filling_factor.hpp"
#include "fluid/joints/network.hpp"

namespace blockweir::joints {

class FillingEquations {
 public:
  /// The unknowns are the nodes that are fed and not held.
  FillingEquations(const Network& network, const std::vector<bool>& fed, const WaterProperties& water);

  /// Adds storage: over `step_s` the storage of a node changes from `stored_m2` to that of u. A node whose walls yield
  /// by `yield_m2_per_pa` stores that much more as its pressure rises from `before_pa`; empty: no node does.
  void store(double step_s, const std::vector<double>& stored_m2, const std::vector<double>& yield_m2_per_pa,
             const std::vector<double>& before_pa);

  [[nodiscard]] Eigen::VectorXd unknowns(const Filling& filling) const;
  void take(const Eigen::VectorXd& u, Filling& filling) const;
  /// Solves for u, starting from this guess, by Newton's method, in which no node changes between full and partly full
  /// more than once in a step. First tries the kept factor, of these or slightly different equations. False if it does
  /// not converge.
  bool solve(Eigen::VectorXd& u, FillingFactor& kept);

  /// Volume stored at each node [m2], at pressure 0.
  [[nodiscard]] std::vector<double> stored(const Filling& filling) const;
  /// Through each channel.
  [[nodiscard]] std::vector<double> flows(const Filling& filling) const;

 private:
  /// The water of a node, and its derivatives with u.
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
  /// Outflow of each node; with the matrix if requested.
  enum class Need { outflow, matrix };
  void assemble(const Eigen::VectorXd& u, Need need);
  bool solve_with(FillingFactor& kept, Eigen::VectorXd& u);
  void add_storage(const std::vector<State>& states, Need need);
  /// The largest outflow over its round-off error.
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
  Eigen::VectorXd terms_;  ///< sum of the absolute terms, at the highest possible pressures
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace blockweir::joints
