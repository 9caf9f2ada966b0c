// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// Large problems in parts: what threads sweep side by side shares no body, and any number of threads makes the same
// bits.
#include "solid/solve/parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "solid/block/parallel.hpp"
#include "solid/solve/force_sweeps.hpp"
#include "solid/solve/overlap_projection.hpp"

namespace blockweir::solid::parts_test {
namespace {

using Bodies = std::vector<std::array<int, 2>>;

constexpr int side = 60;  // of a square of bodies

/// Rows between neighbours in a square whose bodies are numbered at random; the lowest stand on what does not move.
Bodies square(unsigned seed) {
  std::vector<int> number(side * side);
  for (std::size_t b = 0; b < number.size(); ++b) number[b] = static_cast<int>(b);
  std::shuffle(number.begin(), number.end(), std::mt19937(seed));
  const auto body = [&](int x, int y) { return y < 0 ? -1 : number[static_cast<std::size_t>(side * y + x)]; };
  Bodies rows;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      rows.push_back({body(x, y), body(x, y - 1)});
      if (x > 0) rows.push_back({body(x, y), body(x - 1, y)});
    }
  }
  return rows;
}

TEST(Parts, ShareNoBody) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Bodies rows = square(seed);
    const std::vector<int> part = parts_of_rows(rows, side * side);
    ASSERT_EQ(part.size(), rows.size());
    std::map<int, int> part_of_body;
    std::array<int, sweep_parts + 1> count{};
    for (std::size_t k = 0; k < rows.size(); ++k) {
      ++count[static_cast<std::size_t>(part[k])];
      if (part[k] == sweep_parts) continue;
      for (const int b : rows[k]) {
        if (b >= 0) EXPECT_EQ(part_of_body.emplace(b, part[k]).first->second, part[k]) << seed;
      }
    }
    for (std::size_t p = 0; p < sweep_parts; ++p) EXPECT_GT(count[p], static_cast<int>(rows.size()) / 5) << seed;
    EXPECT_LT(count[sweep_parts], static_cast<int>(rows.size()) / 10) << seed;  // what joins them is swept alone
  }
}

TEST(Parts, FewRowsAreOne) {
  EXPECT_TRUE(parts_of_rows(Bodies(many - 1, {0, 1}), 2).empty());
  EXPECT_EQ(parts_of_rows(Bodies(many, {-1, -1}), 2), std::vector<int>(many, 0));
}

/// On one thread and on two.
template <class Result>
std::array<Eigen::VectorXd, 2> on_threads(const Result& result) {
  const std::size_t before = threads();
  std::array<Eigen::VectorXd, 2> results;
  for (const std::size_t n : {1, 2}) {
    set_threads(n);
    results[n - 1] = result();
  }
  set_threads(before);
  return results;
}

TEST(Parts, AreSweptToForcesThatFulfilTheirRulesAndTheSameBits) {
  const Bodies bodies = square(7);
  const auto swept = [&] {
    std::mt19937 draw(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    ForceSweeps sweeps;
    sweeps.begin(Eigen::VectorXd::Constant(3 * side * side, -1e-3), bodies.size());
    for (const auto& ends : bodies) {
      ForceSweeps::Row& row = sweeps.add_row();
      row.rule.friction = 0.3;
      row.rule.compliance = {0.1, 0.1};  // so that there is one answer
      row.apart = {1e-3 * uniform(draw), 1e-3 * uniform(draw)};
      for (const bool second : {false, true}) {
        const int b = ends[second ? 1 : 0];
        if (b < 0) continue;
        const Eigen::Matrix<double, 2, 3> motions =
            Eigen::Matrix<double, 2, 3>::NullaryExpr([&] { return uniform(draw); });
        sweeps.add_end(second, 3 * b, motions, Eigen::Matrix<double, 3, 2>(motions.transpose()));
      }
    }
    sweeps.apply_forces();
    sweeps.settle(3000, 1e-13);
    EXPECT_LE(sweeps.residual(), 1e-11);
    return Eigen::VectorXd(sweeps.displacement());
  };
  const auto [one, two] = on_threads(swept);
  EXPECT_EQ(one, two);
  EXPECT_GT(one.norm(), 1e-3);
}

TEST(Parts, ArePushedApartToTheSameBits) {
  const Bodies bodies = square(9);
  const auto pushed = [&] {
    std::mt19937 draw(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    const std::vector<Eigen::Vector3d> mass(side * side, Eigen::Vector3d(2, 2, 0.5));
    std::vector<Overlap> overlaps;
    for (const auto& [a, b] : bodies) {
      const Eigen::Vector3d up(0.2 * uniform(draw), 1, 0.2 * uniform(draw));
      overlaps.push_back({1e-3 * (0.9 - uniform(draw)), {Overlap::End{a, up}, Overlap::End{b, -up}}});
    }
    OverlapProjection projection(mass, overlaps);
    projection.solve(1e-5);
    EXPECT_LE(projection.deepest(), 1e-5);
    Eigen::VectorXd moved(3 * side * side);
    for (std::size_t b = 0; b < mass.size(); ++b)
      moved.segment<3>(static_cast<Eigen::Index>(3 * b)) = projection.moved(b);
    return moved;
  };
  const auto [one, two] = on_threads(pushed);
  EXPECT_EQ(one, two);
  EXPECT_GT(one.norm(), 1e-3);
}

}  // namespace
}  // namespace blockweir::solid::parts_test
