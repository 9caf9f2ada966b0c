// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve solid_suitesparse
// Factors that are kept serve their own matrix to the bit, one nearby to its residual, and no other.
#include "solid/solve/sparse/sparse_matrix.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <vector>

namespace blockweir::solid::sparse_matrix_test {
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

void set_pattern(SparseMatrix& matrix, int unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < unknowns; ++i) {
    for (const int j : {i - 1, i, i + 1}) {
      if (j >= 0 && j < unknowns) entries.emplace_back(i, j, 0.0);
    }
  }
  matrix.set_pattern(unknowns, entries);
}

class Kept : public testing::TestWithParam<bool> {
 protected:
  Kept() { set_pattern(matrix, size); }
  Eigen::VectorXd solve(double first) { return solve(matrix, first); }
  Eigen::VectorXd solve(SparseMatrix& with, double first) {
    fill(with, first, GetParam());
    Eigen::VectorXd d;
    EXPECT_TRUE(with.solve(GetParam(), f, d));
    return d;
  }
  SparseMatrix matrix;
  const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(size, 1, 2);
};

TEST_P(Kept, TheSameMatrixIsSolvedWithoutNewFactorsToTheSameBits) {
  const Eigen::VectorXd before = solve(1);
  EXPECT_FALSE(matrix.reused());
  EXPECT_EQ(solve(1), before);
  EXPECT_TRUE(matrix.reused());
}

TEST_P(Kept, AMatrixNearbyIsSolvedToItsResidual) {
  solve(1);
  const Eigen::VectorXd d = solve(1.001);
  EXPECT_TRUE(matrix.reused());
  EXPECT_LT((f - matrix.k * d).norm(), 1e-8 * f.norm());
  EXPECT_LT((f - matrix.k * matrix.solve_again(f)).norm(), 1e-8 * f.norm());
}

TEST_P(Kept, AMatrixFarAwayIsFactorizedAnew) {
  solve(1);
  const Eigen::VectorXd d = solve(100);
  EXPECT_FALSE(matrix.reused());
  EXPECT_LT((f - matrix.k * d).norm(), 1e-12 * f.norm());
}

TEST_P(Kept, RestoredFactorsGoOnWithTheSameBits) {
  for (const double stiffness : {1.0, 100.0, 1.0}) solve(stiffness);  // tries have failed, too
  SparseMatrix other;
  set_pattern(other, size);
  other.restore(matrix.kept());
  for (const double stiffness : {1.001, 1.002, 100.0, 1.003}) {
    EXPECT_EQ(solve(other, stiffness), solve(stiffness)) << stiffness;
    EXPECT_EQ(other.reused(), matrix.reused()) << stiffness;
  }
}

TEST_P(Kept, FactorsOfAMatrixWithAnotherPatternAreRefused) {
  solve(1);
  SparseMatrix other;
  set_pattern(other, size + 1);
  EXPECT_THROW(other.restore(matrix.kept()), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Symmetric, Kept, testing::Bool());

std::ptrdiff_t threads_of_this_process() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::distance(begin(tasks), end(tasks));
}

/// A plate of springs, of which CHOLMOD makes supernodes: those ask for threads of OpenMP's, who then stay.
TEST(SparseMatrix, FactorizationsWakeNoThreads) {
  constexpr int side = 100;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < side * side; ++i) {
    entries.emplace_back(i, i, 4.1);
    for (const int j : {i + 1, i + side}) {
      if (j >= side * side || (j == i + 1 && j % side == 0)) continue;
      entries.emplace_back(i, j, -1.0);
      entries.emplace_back(j, i, -1.0);
    }
  }
  SparseMatrix matrix;
  matrix.set_pattern(side * side, entries);
  const Eigen::VectorXd f = Eigen::VectorXd::Ones(side * side);
  Eigen::VectorXd d;
  const std::ptrdiff_t before = threads_of_this_process();
  ASSERT_TRUE(matrix.solve(true, f, d));
  EXPECT_LT((f - matrix.k * d).norm(), 1e-10 * f.norm());
  EXPECT_EQ(threads_of_this_process(), before);
}

}  // namespace
}  // namespace blockweir::solid::sparse_matrix_test
