// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of dry contacts inside their cones of friction, and the motion that they leave, by a primal-dual interior
// point method (Wright 1997, Primal-Dual Interior-Point Methods). A force goes along both edges of its cone, and each
// of these has a motion that it resists: the gap, less or plus what slip opens by the tangent of friction. This is
// associated flow, a convex problem.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "solid/contact/complementary_pair.hpp"
#include "solid/solve/force_sweeps.hpp"
#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {

class ConeForces {
 public:
  /// Forces along both edges of the cone of friction: shear at its negative and at its positive bound.
  using Pairs = std::array<ComplementaryPair, 2>;

  /// Of blocks with unknowns of their own. `matrix`: inertia and elasticity of each block. All must outlive the object.
  ConeForces(const ForceSweeps& sweeps, const Unknowns& unknowns, const std::vector<Matrix6>& matrix);

  /// Far from zero: forces of the largest load, motions of what it moves in the step. `loads`: on the unknowns.
  void begin(const Eigen::VectorXd& loads);
  /// What slips does not open: from here on the motions of a row have its slip added, times the tangent of friction,
  /// smooth within so much [m] of zero (De Saxce and Feng 1998). Their problem is Coulomb's, and not convex.
  void let_slip(double smooth_m);
  /// One solution, by Mehrotra's predictor and corrector; false if there is none.
  bool improve();

  /// The largest part of the loads that nothing balances, as a share of the largest load.
  [[nodiscard]] double unbalanced() const;
  /// Of force and motion, over all pairs.
  [[nodiscard]] double mean_product() const { return mean_product(0); }
  /// By how much gaps and slips are off Coulomb's law when blocks move as these forces have them [m].
  [[nodiscard]] double off_laws_m() const;
  /// Normal and shear of a row, inside its cone of friction [N per metre].
  [[nodiscard]] Eigen::Vector2d force(std::size_t row) const;
  [[nodiscard]] std::vector<Pairs>& pairs() { return pairs_; }
  [[nodiscard]] const std::vector<Pairs>& pairs() const { return pairs_; }
  [[nodiscard]] double friction(std::size_t row) const { return sweeps_.rows()[row].rule.friction; }
  [[nodiscard]] double largest_load() const { return load_; }
  [[nodiscard]] int solutions() const { return solutions_; }
  /// The part of the last correction that kept all forces and motions positive.
  [[nodiscard]] double fraction() const { return fraction_; }

 private:
  bool factorize();
  bool correct(double product);
  void follow();
  void balance();
  [[nodiscard]] Eigen::VectorXd own_motion(const Eigen::VectorXd& forces) const;
  [[nodiscard]] Eigen::Vector2d gained(std::size_t row, const Eigen::VectorXd& displacement) const;
  [[nodiscard]] std::array<double, 2> motions(std::size_t row) const;
  [[nodiscard]] double positive_fraction(double within) const;
  [[nodiscard]] double mean_product(double fraction) const;
  void add_forces(std::size_t row, const Eigen::Vector2d& force, Eigen::VectorXd& to) const;

  /// Of a row's slip, as its motions have it: its size, smooth about zero, and d size / d slip.
  struct Slip {
    double size_m = 0;
    double slope = 0;
  };

  const ForceSweeps& sweeps_;
  const Unknowns& unknowns_;
  const std::vector<Matrix6>& matrix_;
  std::vector<int> block_of_;  ///< by the first of its unknowns
  std::unique_ptr<LinearSystem> system_;
  std::vector<Pairs> pairs_;
  std::vector<Slip> slips_;
  bool opens_ = true;  ///< what slips
  Eigen::VectorXd loads_;
  double load_ = 0;
  Eigen::VectorXd displacement_;
  Eigen::VectorXd change_;
  Eigen::VectorXd unbalanced_;
  double fraction_ = 1;  ///< of the last change that was followed
  int solutions_ = 0;
};

}  // namespace blockweir::solid
