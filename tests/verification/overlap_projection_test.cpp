// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_solve
// What overlaps is pushed apart, and no farther.
#include "solid/solve/overlap_projection.hpp"

#include <gtest/gtest.h>

#include <random>

namespace blockweir::solid::overlap_projection_test {
namespace {

constexpr double tolerance_m = 1e-9;
const Eigen::Vector3d right(1, 0, 0);

Overlap between(int left_body, int right_body, double gap) {
  return {gap, {Overlap::End{right_body, right}, Overlap::End{left_body, -right}}};
}

TEST(OverlapProjection, OfTwoBodiesTheLightOneMovesFarther) {
  OverlapProjection push({{3, 3, 1}, {1, 1, 1}}, {between(0, 1, -0.4)});
  push.solve(tolerance_m);
  EXPECT_NEAR(push.moved(0).x(), -0.1, 1e-7);
  EXPECT_NEAR(push.moved(1).x(), 0.3, 1e-7);
  EXPECT_LE(push.deepest(), 1e-7);
}

TEST(OverlapProjection, WhatDoesNotOverlapStays) {
  OverlapProjection push({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {between(0, 1, -0.4), between(1, 2, 0.5)});
  push.solve(tolerance_m);
  EXPECT_TRUE(push.moved(2).isZero(0));
}

TEST(OverlapProjection, WhatIsPushedPushesOn) {
  OverlapProjection push({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
                         {between(-1, 0, -0.4), between(0, 1, 0.1), between(1, 2, 0)});
  push.solve(tolerance_m);
  EXPECT_NEAR(push.moved(0).x(), 0.4, 1e-6);
  EXPECT_NEAR(push.moved(1).x(), 0.3, 1e-6);
  EXPECT_NEAR(push.moved(2).x(), 0.3, 1e-6);
}

/// Against pushes that are made one after another until none is left to make.
TEST(OverlapProjection, RandomPilesHaveNoOverlapLeftAndNoLessMassIsMoved) {
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  for (int pile = 0; pile < 50; ++pile) {
    constexpr int bodies = 8;
    std::vector<Eigen::Vector3d> mass;
    for (int b = 0; b < bodies; ++b) mass.emplace_back(Eigen::Vector3d::Constant(0.5 + std::abs(any(random))));
    std::vector<Overlap> overlaps;
    for (int b = 0; b < bodies; ++b) {
      const Eigen::Vector3d up(0.3 * any(random), 1, 0.3 * any(random));
      overlaps.push_back({-0.01 * std::abs(any(random)), {Overlap::End{b, up}, Overlap::End{b - 1, -up}}});
    }
    OverlapProjection push(mass, overlaps);
    push.solve(tolerance_m);
    EXPECT_LE(push.deepest(), 1e-7) << pile;  // of overlaps of 1e-2: springs as stiff leave no more

    std::vector<Eigen::Vector3d> moved(bodies, Eigen::Vector3d::Zero());
    std::vector<double> pushed(overlaps.size(), 0);
    for (int sweep = 0; sweep < 20000; ++sweep) {
      for (std::size_t i = 0; i < overlaps.size(); ++i) {
        double gap = overlaps[i].gap;
        double flexibility = 0;
        for (const auto& [body, opens] : overlaps[i].ends) {
          if (body < 0) continue;
          gap += opens.dot(moved[static_cast<std::size_t>(body)]);
          flexibility += opens.dot(opens.cwiseQuotient(mass[static_cast<std::size_t>(body)]));
        }
        const double by = std::max(-gap / flexibility, -pushed[i]);
        pushed[i] += by;
        for (const auto& [body, opens] : overlaps[i].ends) {
          if (body < 0) continue;
          const auto b = static_cast<std::size_t>(body);
          moved[b] += by * opens.cwiseQuotient(mass[b]);
        }
      }
    }
    for (std::size_t b = 0; b < bodies; ++b) EXPECT_LE((push.moved(b) - moved[b]).norm(), 1e-5) << pile;
  }
}

}  // namespace
}  // namespace blockweir::solid::overlap_projection_test
