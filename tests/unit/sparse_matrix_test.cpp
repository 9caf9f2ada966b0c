// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// Factors that are kept serve their own matrix to the bit, one nearby to its residual, and no other.
#include "solid/solve/sparse_matrix.hpp"

#include <gtest/gtest.h>

namespace blockweir::solid {
namespace {

constexpr int size = 50;

/// A chain of springs, of which the first has this stiffness.
void fill(SparseMatrix& matrix, double first, bool symmetric) {
  matrix.set_zero();
  for (int i = 0; i < size; ++i) {
    matrix.k.coeffRef(i, i) += i == 0 ? 1 + first : 2.5;
    if (i + 1 == size) continue;
    matrix.k.coeffRef(i, i + 1) -= 1;
    matrix.k.coeffRef(i + 1, i) -= symmetric ? 1 : 0.5;
  }
}

class Kept : public testing::TestWithParam<bool> {
 protected:
  Kept() {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) {
      for (const int j : {i - 1, i, i + 1}) {
        if (j >= 0 && j < size) entries.emplace_back(i, j, 0.0);
      }
    }
    matrix.set_pattern(size, entries);
  }
  Eigen::VectorXd solve(double first) {
    fill(matrix, first, GetParam());
    Eigen::VectorXd d;
    EXPECT_TRUE(matrix.solve(GetParam(), f, d));
    return d;
  }
  SparseMatrix matrix;
  const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(size, 1, 2);
};

TEST_P(Kept, TheSameMatrixIsSolvedWithoutNewFactorsToTheSameBits) {
  const Eigen::VectorXd before = solve(1);
  EXPECT_FALSE(matrix.reused());
  matrix.begin_step();
  EXPECT_EQ(solve(1), before);
  EXPECT_TRUE(matrix.reused());
}

TEST_P(Kept, AMatrixNearbyIsSolvedByRefinementWithinAStepOnly) {
  solve(1);
  const Eigen::VectorXd d = solve(1.001);
  EXPECT_TRUE(matrix.reused());
  EXPECT_LT((f - matrix.k * d).norm(), 1e-8 * f.norm());
  EXPECT_LT((f - matrix.k * matrix.solve_again(f)).norm(), 1e-8 * f.norm());
  matrix.begin_step();
  solve(1.002);
  EXPECT_FALSE(matrix.reused());
}

TEST_P(Kept, AMatrixFarAwayIsFactorizedAnew) {
  solve(1);
  const Eigen::VectorXd d = solve(100);
  EXPECT_FALSE(matrix.reused());
  EXPECT_LT((f - matrix.k * d).norm(), 1e-12 * f.norm());
}

INSTANTIATE_TEST_SUITE_P(Symmetric, Kept, testing::Bool());

}  // namespace
}  // namespace blockweir::solid
