// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/positive_mass.hpp"

#include <gtest/gtest.h>

#include <random>

namespace blockweir::openfoam::positive_mass_test {
namespace {

Eigen::Matrix3d matrix(const std::array<double, 6>& m) {
  return (Eigen::Matrix3d() << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5]).finished();
}

TEST(PositiveMass, OfWhatResistsAllMotionIsItself) {
  const std::array<double, 6> row{2e3, 100, -50, 1e3, 20, 400};
  EXPECT_EQ(positive_mass(row, 3), row);
  EXPECT_EQ(positive_mass({}, 3), (std::array<double, 6>{}));
}

/// A plate pushes water along one way only; the error of its turning takes one mode below zero. No more than the error
/// is taken away, also where a resistance is next to nothing, and in all units alike.
TEST(PositiveMass, HasNoModeBelowZeroAndStaysAsNearAsTheErrorIs) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 10'000; ++n) {
    const double reach_m = std::pow(10, any(random));
    const Eigen::Vector3d way{any(random), any(random), any(random)};  // braces: in this order with every compiler
    const Eigen::Matrix3d exact = 1e3 * way * way.transpose();
    Eigen::Matrix3d error;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) error(j, i) = error(i, j) = any(random);
    }
    const Eigen::DiagonalMatrix<double, 3> turned(1, 1, reach_m);
    const Eigen::Matrix3d mass = turned * (exact + error) * turned;
    const Eigen::Matrix3d positive =
        matrix(positive_mass({mass(0, 0), mass(0, 1), mass(0, 2), mass(1, 1), mass(1, 2), mass(2, 2)}, reach_m));
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(positive).eigenvalues()[0], -1e-9);
    EXPECT_LE((turned.inverse() * (positive - mass) * turned.inverse()).norm(), error.norm() + 1e-9) << n;
  }
}

}  // namespace
}  // namespace blockweir::openfoam::positive_mass_test
