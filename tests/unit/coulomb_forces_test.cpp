// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Forces of Coulomb's law at several contacts, and the pivoting that finds them.
#include "solid/contact/coulomb_forces.hpp"

#include <gtest/gtest.h>

#include <random>

#include "bridge/scene/at.hpp"
#include "solid/contact/complementarity.hpp"

namespace blockweir::solid::coulomb_forces_test {
namespace {

/// At one contact of 1 m per N per metre.
Eigen::Vector2d forces_at_one(double gap_m, double slip_m, double friction) {
  const auto found = coulomb_forces({Eigen::Vector2d(gap_m, slip_m), Eigen::Matrix2d::Identity(), {friction}});
  return found ? Eigen::Vector2d(*found) : Eigen::Vector2d::Constant(-1);
}

TEST(CoulombForces, OpenStickAndSlip) {
  const auto are = [](const Eigen::Vector2d& got, double normal, double shear) {
    return (got - Eigen::Vector2d(normal, shear)).norm() < 1e-14;
  };
  EXPECT_TRUE(are(forces_at_one(0.5, 2, 0.5), 0, 0));
  EXPECT_TRUE(are(forces_at_one(-1, 0.25, 0.5), 1, -0.25));
  EXPECT_TRUE(are(forces_at_one(-1, -0.25, 0.5), 1, 0.25));
  EXPECT_TRUE(are(forces_at_one(-1, 3, 0.5), 1, -0.5));
  EXPECT_TRUE(are(forces_at_one(-1, -3, 0), 1, 0));
}

TEST(CoulombForces, DoNotDependOnTheUnits) {
  for (const double unit : {1e-15, 1e-9, 1.0, 1e6}) {
    const auto found =
        coulomb_forces({Eigen::Vector2d(-1e-3 * unit, 1e-4 * unit), 1e-8 * Eigen::Matrix2d::Identity(), {0.6}});
    ASSERT_TRUE(found) << unit;
    EXPECT_NEAR((*found)[0] / (1e5 * unit), 1, 1e-12) << unit;
    EXPECT_NEAR((*found)[1] / (-1e4 * unit), 1, 1e-12) << unit;
  }
}

/// Many contacts of few bodies, so that forces at one move all others and some are redundant.
TEST(CoulombForces, FulfilTheLawWhereContactsMoveEachOther) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> of(-1, 1);
  int solved = 0;
  for (int problem = 0; problem < 400; ++problem) {
    const Eigen::Index n = 1 + problem % 20;
    const Eigen::Index unknowns = 3 * (1 + problem % 7);
    const Eigen::MatrixXd pull = Eigen::MatrixXd::NullaryExpr(unknowns, 2 * n, [&] { return of(random); });
    const Eigen::VectorXd way = Eigen::VectorXd::NullaryExpr(unknowns, [&] { return of(random); });
    const double friction = 0.75 * (1 + of(random));
    const CoulombContacts contacts{pull.transpose() * way, pull.transpose() * pull,
                                   std::vector<double>(at(static_cast<int>(n)), friction)};
    const auto forces = coulomb_forces(contacts);
    if (!forces) continue;
    ++solved;
    const Eigen::VectorXd apart = contacts.apart + contacts.flexibility * *forces;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double normal = (*forces)[2 * i];
      const double shear = (*forces)[2 * i + 1];
      const double slip = apart[2 * i + 1];
      EXPECT_GE(normal, 0);
      EXPECT_GE(apart[2 * i], -1e-8);
      EXPECT_NEAR(normal * apart[2 * i], 0, 1e-7);
      EXPECT_LE(std::abs(shear), friction * normal + 1e-8);
      EXPECT_NEAR(slip * shear, -std::abs(slip) * friction * normal, 1e-7);
    }
  }
  EXPECT_GT(solved, 390);
}

TEST(Complementarity, HasNoSolutionOnARay) {
  EXPECT_FALSE(solve_complementarity(-Eigen::MatrixXd::Identity(1, 1), -Eigen::VectorXd::Ones(1)));
}

TEST(Complementarity, IsZeroWhereNothingIsNegative) {
  const auto z = solve_complementarity(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(0, 3));
  ASSERT_TRUE(z);
  EXPECT_EQ(*z, Eigen::VectorXd::Zero(2));
}

}  // namespace
}  // namespace blockweir::solid::coulomb_forces_test
