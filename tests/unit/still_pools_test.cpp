// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// Still water is drawn where the solver has it, and nowhere else.
#include "bridge/picture/still_pools.hpp"

#include <gtest/gtest.h>

namespace blockweir::picture::still_pools_test {
namespace {

using nlohmann::json;

constexpr View view{-10, 10, -2, 8};

/// A gate of two legs and a beam on the ground, water before it to 3 m.
json gate() {
  return {{"upstream_level_m", 3},
          {"downstream_level_m", nullptr},
          {"blocks",
           {{{"fixed", true}, {"outline", {{-10, -1}, {10, -1}, {10, 0}, {-10, 0}}}},
            {{"fixed", false}, {"outline", {{-4, 0}, {-3, 0}, {-3, 5}, {-4, 5}}}},
            {{"fixed", false}, {"outline", {{3, 0}, {4, 0}, {4, 5}, {3, 5}}}},
            {{"fixed", false}, {"outline", {{-4, 5}, {4, 5}, {4, 6}, {-4, 6}}}}}},
          {"panels", {{-10, 0, -4, 0, 30000, 30000, 0}, {-4, 3, -4, 0, 0, 30000, 0}}}};
}

double area(const std::vector<Eigen::Vector2d>& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return sum;
}

TEST(StillPools, EndAtTheFacesThatAreWet) {
  const auto pools = still_pools(gate(), view);
  ASSERT_EQ(pools.size(), 1U);
  EXPECT_NEAR(area(pools[0]), 18, 0.1);
  for (const Eigen::Vector2d& p : pools[0]) EXPECT_LE(p.x(), -4);
}

/// A face inside that is wet, too: the last wet face is beyond the chamber, whose water is another body.
TEST(StillPools, AChamberIsDrawnWhereItsFacesAreWet) {
  json frame = gate();
  frame["panels"].push_back({-3, 0, -3, 3, 30000, 0, 0});
  frame["panels"].push_back({3, 3, 3, 0, 0, 30000, 0});
  const auto pools = still_pools(frame, view);
  ASSERT_EQ(pools.size(), 2U);
  EXPECT_NEAR(area(pools[0]) + area(pools[1]), 36, 0.3);
}

/// A wall that has slid off its rock and falls beside it: the solver still presses on the rock.
TEST(StillPools, AreDrawnToTheirLevelWhenAllThatMovesHasLeftTheView) {
  json frame = gate();
  for (std::size_t b = 1; b < frame["blocks"].size(); ++b) {
    for (json& p : frame["blocks"][b]["outline"]) p[0] = p[0].get<double>() + 30, p[1] = p[1].get<double>() - 20;
  }
  frame["panels"] = json::parse("[[10, 0, -10, 0, 30000, 30000, 0]]");
  const auto pools = still_pools(frame, view);
  ASSERT_EQ(pools.size(), 1U);
  EXPECT_NEAR(area(pools[0]), 20 * 3, 0.3);
}

/// As over bricks of a dam that has fallen.
TEST(StillPools, DoNotStandHigherThanTheHighestBlock) {
  json frame = gate();
  EXPECT_FALSE(above_all(frame));
  frame["upstream_level_m"] = 7;
  EXPECT_TRUE(above_all(frame));
  for (const auto& pool : still_pools(frame, view)) {
    for (const Eigen::Vector2d& p : pool) EXPECT_LE(p.y(), 6 + 1e-6);
  }
}

TEST(StillPools, AreNoneWhereNoFaceIsWet) {
  json frame = gate();
  frame["panels"] = json::array();
  EXPECT_TRUE(still_pools(frame, view).empty());
}

}  // namespace
}  // namespace blockweir::picture::still_pools_test
