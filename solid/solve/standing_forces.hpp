// SPDX-License-Identifier: GPL-3.0-or-later
// Forces by which blocks at rest stay there, if any do. With associated flow (what slips opens by the tangent of
// friction) the motion of a step is that of a convex problem; if nothing slips in it, its forces fulfil Coulomb's law,
// too. A primal-dual interior point method (Wright 1997, Primal-Dual Interior-Point Methods) finds them in some 15
// solutions. Sweeps, whose forces creep through the structure, would let it slip meanwhile.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "solid/contact/complementary_pair.hpp"
#include "solid/solve/force_sweeps.hpp"
#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {

class StandingForces {
 public:
  /// Of blocks with unknowns of their own. `matrix`: inertia and elasticity of each block. All must outlive the object.
  StandingForces(const ForceSweeps& sweeps, const Unknowns& unknowns, const std::vector<Matrix6>& matrix);

  /// Under `loads`, forces on the unknowns: whether nothing that presses slips by more than that [m]. What opens may.
  bool found(const Eigen::VectorXd& loads, double enough_m);
  /// Normal and shear of a row, inside its cone of friction [N per metre].
  [[nodiscard]] Eigen::Vector2d force(std::size_t row) const;
  [[nodiscard]] int solutions() const { return solutions_; }

 private:
  /// Forces along both edges of the cone of friction: shear at its negative and at its positive bound.
  using Pairs = std::array<ComplementaryPair, 2>;

  void begin(const Eigen::VectorXd& loads);
  bool factorize();
  bool correct(double product);
  void follow(double fraction);
  [[nodiscard]] Eigen::VectorXd unbalanced(const Eigen::VectorXd& loads) const;
  [[nodiscard]] std::array<double, 2> motions(std::size_t row, const Eigen::VectorXd& displacement) const;
  [[nodiscard]] double positive_fraction(double within) const;
  [[nodiscard]] double mean_product(double fraction) const;
  [[nodiscard]] bool stands(double load, double enough_m) const;
  [[nodiscard]] double lost_in_slip() const;
  void add_forces(std::size_t row, const Eigen::Vector2d& force, Eigen::VectorXd& to) const;

  const ForceSweeps& sweeps_;
  const Unknowns& unknowns_;
  const std::vector<Matrix6>& matrix_;
  std::vector<int> block_of_;  ///< by the first of its unknowns
  std::unique_ptr<LinearSystem> system_;
  std::vector<Pairs> pairs_;
  Eigen::VectorXd displacement_;
  Eigen::VectorXd change_;
  Eigen::VectorXd unbalanced_;
  int solutions_ = 0;
};

}  // namespace blockweir::solid
