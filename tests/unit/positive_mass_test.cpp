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
  EXPECT_EQ(positive_mass(row), row);
  EXPECT_EQ(positive_mass({}), (std::array<double, 6>{}));
}

/// A plate pushes water along one way only; the error of its turning takes one mode below zero.
TEST(PositiveMass, HasNoModeBelowZeroAndStaysNear) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 100; ++n) {
    const Eigen::Vector3d way(any(random), any(random), any(random));
    Eigen::Matrix3d mass = 1e3 * way * way.transpose();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) mass(j, i) = mass(i, j) = mass(i, j) + any(random);
    }
    const Eigen::Matrix3d positive =
        matrix(positive_mass({mass(0, 0), mass(0, 1), mass(0, 2), mass(1, 1), mass(1, 2), mass(2, 2)}));
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(positive).eigenvalues()[0], -1e-9);
    EXPECT_LE((positive - mass).norm(), 0.1 * mass.norm()) << n;
  }
}

}  // namespace
}  // namespace blockweir::openfoam::positive_mass_test
