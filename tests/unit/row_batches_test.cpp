// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// Rows in batches, and rows that are visited one by one, end with forces that fulfil their rules.
#include "solid/solve/row_batches.hpp"

#include <gtest/gtest.h>

#include <random>

#include "solid/solve/force_sweeps.hpp"

namespace blockweir::solid::row_batches_test {
namespace {

constexpr int bodies = 40;

/// Rows between random bodies, or a body and what does not move, with unit masses, under random loads. Every third body
/// has six unknowns, the others three; `padding` further unknowns of each move by nothing.
void tangle(unsigned seed, int padding, ForceSweeps& sweeps) {
  std::mt19937 draw(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Eigen::Index> first = {0};
  for (int b = 0; b < bodies; ++b) first.push_back(first.back() + (b % 3 == 0 ? 6 : 3) + padding);
  sweeps.begin(Eigen::VectorXd::NullaryExpr(first.back(), [&] { return uniform(draw); }), 3 * bodies);
  for (int k = 0; k < 3 * bodies; ++k) {
    ForceSweeps::Row& row = sweeps.add_row();
    row.rule.friction = 0.3;
    row.rule.compliance = {0.1, 0.1};  // so that there is one answer
    row.apart = {uniform(draw), uniform(draw)};
    for (const bool second : {false, true}) {
      if (second && k % 4 == 0) continue;
      const int b = (k + (second ? 7 + k % 5 : 0)) % bodies;
      const Eigen::Index count = first[static_cast<std::size_t>(b) + 1] - first[static_cast<std::size_t>(b)];
      Eigen::Matrix2Xd motions = Eigen::Matrix2Xd::NullaryExpr(2, count, [&] { return uniform(draw) / 2; });
      motions.rightCols(padding).setZero();
      sweeps.add_end(second, first[static_cast<std::size_t>(b)], motions, Eigen::MatrixX2d(motions.transpose()));
    }
  }
  sweeps.apply_forces();
}

ForceSweeps tangle(unsigned seed, int padding) {
  ForceSweeps sweeps;
  tangle(seed, padding, sweeps);
  return sweeps;
}

TEST(RowBatches, EndWithForcesThatFulfilTheirRules) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    ForceSweeps together = tangle(seed, 0);
    ForceSweeps alone = tangle(seed, most_unknowns);  // too many unknowns for batches
    together.settle(20000, 1e-13);
    alone.settle(20000, 1e-13);
    EXPECT_LE(together.residual(), 1e-11) << seed;
    EXPECT_LE(alone.residual(), 1e-11) << seed;
  }
}

/// Bodies that push the same water move each other: a row may move from the middle of one body on.
TEST(RowBatches, DoNotHoldRowsThatShareSomeUnknowns) {
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  ForceSweeps sweeps;
  sweeps.begin(Eigen::VectorXd::Constant(9, -1), 8);
  for (Eigen::Index k = 0; k < 8; ++k) {
    ForceSweeps::Row& row = sweeps.add_row();
    row.rule.friction = 0.3;
    row.rule.compliance = {0.1, 0.1};
    row.apart = {-1, uniform(draw)};
    const Eigen::Matrix2Xd motions = Eigen::Matrix2Xd::NullaryExpr(2, 5, [&] { return uniform(draw) / 2; });
    sweeps.add_end(false, k % 5, motions, Eigen::MatrixX2d(motions.transpose()));
  }
  sweeps.apply_forces();
  EXPECT_LT(sweeps.settle(20000, 1e-13), 20000);
  EXPECT_LE(sweeps.residual(), 1e-11);
  const Eigen::VectorXd settled = sweeps.displacement();
  sweeps.displace(Eigen::VectorXd::Constant(9, -1));
  sweeps.apply_forces();
  EXPECT_LE((sweeps.displacement() - settled).cwiseAbs().maxCoeff(), 1e-12);
}

/// Each row is in a batch once, and none of a batch shares a block: momentum balances after any sweep.
TEST(RowBatches, MoveWhatTheirForcesMove) {
  ForceSweeps sweeps = tangle(7, 0);
  const Eigen::VectorXd start = sweeps.displacement();
  for (int n = 0; n < 5; ++n) sweeps.sweep();
  ForceSweeps other = tangle(7, 0);
  for (std::size_t k = 0; k < sweeps.rows().size(); ++k) other.rows()[k].force = sweeps.rows()[k].force;
  other.apply_forces();
  EXPECT_LE((other.displacement() - sweeps.displacement()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT((start - sweeps.displacement()).cwiseAbs().maxCoeff(), 0.1);
}

/// Rows between the same bodies keep their batches, others get new ones.
TEST(RowBatches, AreTheSameWhateverWasSweptBefore) {
  ForceSweeps used;
  for (const auto& [seed, padding] : {std::pair(3U, 0), {4U, 0}, {4U, most_unknowns}, {3U, 0}}) {
    tangle(seed, padding, used);
    ForceSweeps fresh = tangle(seed, padding);
    for (int n = 0; n < 5; ++n) EXPECT_EQ(used.sweep(), fresh.sweep());
    EXPECT_EQ(used.displacement(), fresh.displacement());
  }
}

/// Two bodies that water joins move each other: both ends of a row have the unknowns of both.
TEST(RowBatches, AddUpWhatBothEndsOfARowMove) {
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  ForceSweeps sweeps;
  sweeps.begin(Eigen::VectorXd::Constant(6, -1), 4);
  for (int k = 0; k < 4; ++k) {
    ForceSweeps::Row& row = sweeps.add_row();
    row.rule.friction = 0.3;
    row.rule.compliance = {0.1, 0.1};
    row.apart = {-1, uniform(draw)};
    for (const bool second : {false, true}) {
      const Eigen::Matrix2Xd motions = Eigen::Matrix2Xd::NullaryExpr(2, 6, [&] { return uniform(draw) / 2; });
      sweeps.add_end(second, 0, motions, Eigen::MatrixX2d(motions.transpose()));
    }
  }
  sweeps.apply_forces();
  EXPECT_LT(sweeps.settle(20000, 1e-13), 20000);
  const Eigen::VectorXd settled = sweeps.displacement();
  sweeps.displace(Eigen::VectorXd::Constant(6, -1));
  sweeps.apply_forces();
  EXPECT_LE((sweeps.displacement() - settled).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace blockweir::solid::row_batches_test
