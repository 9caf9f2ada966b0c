// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// A stack of weights, each on the one below: sweeps go to the answer, and may be left at any time.
#include "solid/solve/force_sweeps.hpp"

#include <gtest/gtest.h>

namespace blockweir::solid::force_sweeps_test {
namespace {

constexpr Eigen::Index weights = 5;

/// Of unit masses that move up and down; gravity has moved each by -1.
ForceSweeps stack() {
  ForceSweeps sweeps;
  sweeps.begin(Eigen::VectorXd::Constant(weights, -1), weights);
  for (Eigen::Index k = 0; k < weights; ++k) {
    sweeps.add_row();
    Eigen::Matrix2Xd up = Eigen::Matrix2Xd::Zero(2, 1);
    up(0, 0) = 1;
    Eigen::MatrixX2d response = Eigen::MatrixX2d::Zero(1, 2);
    response(0, 0) = 1;
    sweeps.add_end(false, k, up, response);
    if (k > 0) sweeps.add_end(true, k - 1, -up, -response);
    sweeps.rows().back().flexibility(1, 1) = 1;  // what slips is of no interest
  }
  sweeps.apply_forces();
  return sweeps;
}

TEST(ForceSweeps, CarryWhatStandsAbove) {
  ForceSweeps sweeps = stack();
  while (sweeps.sweep() > 1e-14) {
  }
  for (Eigen::Index k = 0; k < weights; ++k) {
    EXPECT_NEAR(sweeps.rows()[static_cast<std::size_t>(k)].force.x(), static_cast<double>(weights - k), 1e-12);
    EXPECT_NEAR(sweeps.displacement()[k], 0, 1e-12);
  }
}

TEST(ForceSweeps, BalanceMomentumAndPullNothingWhereverTheyStop) {
  ForceSweeps sweeps = stack();
  for (int sweep = 0; sweep < 3; ++sweep) {
    sweeps.sweep();
    for (Eigen::Index k = 0; k < weights; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double above = k + 1 < weights ? sweeps.rows()[i + 1].force.x() : 0;
      EXPECT_GE(sweeps.rows()[i].force.x(), 0);
      EXPECT_NEAR(sweeps.displacement()[k], sweeps.rows()[i].force.x() - above - 1, 1e-14);
    }
  }
}

/// The lower weight is pushed up into the upper one, whose row had been looked at before, and was open.
TEST(ForceSweeps, EndOnlyWhenRowsThatWereOpenHaveBeenLookedAtAgain) {
  ForceSweeps sweeps;
  sweeps.begin(Eigen::VectorXd::Zero(2), 2);
  Eigen::Matrix2Xd up = Eigen::Matrix2Xd::Zero(2, 1);
  up(0, 0) = 1;
  const Eigen::MatrixX2d response = up.transpose();
  for (const bool ground : {false, true}) {
    ForceSweeps::Row& row = sweeps.add_row();
    row.apart = ground ? Eigen::Vector2d(-3, 0) : Eigen::Vector2d(1, 0);
    sweeps.add_end(false, ground ? 0 : 1, up, response);
    if (!ground) sweeps.add_end(true, 0, -up, -response);
    sweeps.rows().back().flexibility(1, 1) = 1;
  }
  sweeps.apply_forces();
  EXPECT_LT(sweeps.settle(1000, 1e-14), 1000);
  EXPECT_LE(sweeps.residual(), 1e-13);
  EXPECT_NEAR(sweeps.displacement()[0], 3, 1e-12);
  EXPECT_NEAR(sweeps.displacement()[1], 2, 1e-12);
}

TEST(ForceSweeps, GoOnFromForcesThatTheyAreGiven) {
  ForceSweeps sweeps = stack();
  for (Eigen::Index k = 0; k < weights; ++k) {
    sweeps.rows()[static_cast<std::size_t>(k)].force.x() = static_cast<double>(weights - k);
  }
  sweeps.apply_forces();
  EXPECT_EQ(sweeps.sweep(), 0);
}

}  // namespace
}  // namespace blockweir::solid::force_sweeps_test
