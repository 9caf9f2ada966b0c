// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir
// Factors of sparse matrices, front by front, against Eigen's factors of the same matrices stored in full.
#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <random>

#include "fluid/reservoir/pressure_equation.hpp"
#include "tests/unit/reservoir_wall.hpp"

namespace blockweir::reservoir::frontal_cholesky_test {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Graphs of `count` unknowns, `bonds` of them drawn at random, each of random stiffness; all are held a little.
Sparse lower_half(int count, int bonds, std::mt19937& random) {
  std::uniform_int_distribution<int> unknown(0, count - 1);
  std::uniform_real_distribution<double> stiffness(0.1, 10);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, stiffness(random));
  for (int n = 0; n < bonds; ++n) {
    const auto [i, j] = std::pair{unknown(random), unknown(random)};
    if (i == j) continue;
    const double k = stiffness(random);
    entries.emplace_back(i, i, k);
    entries.emplace_back(j, j, k);
    entries.emplace_back(std::max(i, j), std::min(i, j), -k);
  }
  Sparse lower(count, count);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

Sparse some_sides(int count, int sides, std::mt19937& random) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < sides; ++k) {
    for (int n = 0; n < 3; ++n) {
      entries.emplace_back(static_cast<int>(random() % static_cast<unsigned>(count)), k, 1.0 + n);
    }
  }
  Sparse right(count, sides);
  right.setFromTriplets(entries.begin(), entries.end());
  return right;
}

/// From a matrix without bonds to one that is full. Sides: less than are solved for at once, as many, and more.
TEST(FrontalCholesky, SolvesWhatFactorsStoredInFullDo) {
  std::mt19937 random(1);
  for (const auto& [count, bonds, sides] :
       {std::array{1, 0, 1}, {7, 0, 8}, {40, 35, 3}, {60, 90, 17}, {25, 900, 9}, {300, 500, 40}}) {
    SCOPED_TRACE(count);
    const Sparse first = lower_half(count, bonds, random);
    FrontalCholesky factors(first);
    for (const double scale : {1.0, 3.0}) {  // others of the same places
      const Sparse lower = scale * first;
      ASSERT_TRUE(factors.factorize(lower));
      const Eigen::LLT<Eigen::MatrixXd> expected(Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>());
      const Sparse right = some_sides(count, sides, random);
      const Eigen::MatrixXd x = expected.solve(Eigen::MatrixXd(right));
      const double most = x.cwiseAbs().maxCoeff();
      EXPECT_LT((factors.solve(right.col(0)) - x.col(0)).cwiseAbs().maxCoeff(), 1e-13 * most);
      const Eigen::MatrixXd flexibility = right.transpose() * x;
      EXPECT_LT((factors.flexibility(right) - flexibility).cwiseAbs().maxCoeff(), 1e-12 * most);
      std::vector<int> wanted;
      for (int i = 0; i < count; i += 3) wanted.push_back(i);
      Eigen::Index solved = 0;
      factors.solve(right, wanted, [&](Eigen::Index from, const Eigen::MatrixXd& part) {
        EXPECT_EQ(from, solved);
        solved += part.cols();
        for (std::size_t i = 0; i < wanted.size(); ++i) {
          const auto row = static_cast<Eigen::Index>(i);
          const auto off = part.row(row) - x.row(wanted[i]).segment(from, part.cols());
          EXPECT_LT(off.cwiseAbs().maxCoeff(), 1e-13 * most);
        }
      });
      EXPECT_EQ(solved, sides);
    }
  }
}

TEST(FrontalCholesky, SaysWhereAMatrixIsNotPositiveDefinite) {
  Sparse lower(3, 3);
  const std::vector<Eigen::Triplet<double>> free{{0, 0, 0.1}, {1, 1, 0.4}, {2, 2, 0.3}, {1, 0, -0.1}, {2, 1, -0.3}};
  lower.setFromTriplets(free.begin(), free.end());
  FrontalCholesky factors(lower);
  EXPECT_FALSE(factors.factorize(lower));  // but for a rounding its rows add up to zero
  lower.coeffRef(2, 2) = 0.2;
  EXPECT_FALSE(factors.factorize(lower));
  lower.coeffRef(2, 2) = 0.31;
  EXPECT_TRUE(factors.factorize(lower));
}

TEST(FrontalCholesky, WaterWithoutASurfaceHasNoPressures) {
  WaterMesh mesh = mesh_of({}, 0.5, {-100, true, {}});
  for (BoundarySide& side : mesh.side) {
    if (side.kind == BoundarySide::Kind::surface) side.kind = BoundarySide::Kind::bed;
  }
  try {
    const PressureEquation equation(mesh, {}, {true, false}, 1);
    ADD_FAILURE() << "it has an answer";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("are not determined"),
                                             testing::HasSubstr("expected a free surface on each body of water")));
  }
}

}  // namespace
}  // namespace blockweir::reservoir::frontal_cholesky_test
