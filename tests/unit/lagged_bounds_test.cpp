// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Bounds of two contacts whose normal forces depend on them.
#include "solid/contact/lagged_bounds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace blockweir::solid::lagged_bounds_test {
namespace {

constexpr std::array contacts{0, 1};
constexpr std::array fixed_point{3.0, 5.0};
constexpr double tolerance = 1e-9;

/// Calls until bounds stand, at most 50, where what is allowed of each is `gain` times as far from its fixed point as
/// the bound itself.
int calls(const std::array<double, 2>& gain) {
  LaggedBounds bounds;
  bounds.begin(2);
  bounds.set(0, 2);
  bounds.set(1, 5.5);
  for (int call = 1; call <= 50; ++call) {
    const auto allowed = [&](int k) { return fixed_point[at(k)] + gain[at(k)] * (bounds[k] - fixed_point[at(k)]); };
    if (!bounds.follow(contacts, allowed, [](int /*k*/) { return tolerance; })) continue;
    EXPECT_NEAR(bounds[0], fixed_point[0], 10 * tolerance) << gain[0];
    EXPECT_NEAR(bounds[1], fixed_point[1], 10 * tolerance) << gain[1];
    return call;
  }
  return std::numeric_limits<int>::max();
}

TEST(LaggedBounds, StandWhereForcesAllowWhatTheyAre) {
  LaggedBounds bounds;
  bounds.begin(2);
  bounds.set(1, 7);
  const std::array one{1};
  EXPECT_TRUE(bounds.follow(
      one, [](int /*k*/) { return 7.0; }, [](int /*k*/) { return 0.0; }));
  EXPECT_EQ(bounds[1], 7);
}

TEST(LaggedBounds, GoAllTheWayAtFirst) {
  LaggedBounds bounds;
  bounds.begin(2);
  bounds.set(0, 1);
  bounds.set(1, 2);
  EXPECT_FALSE(bounds.follow(
      contacts, [](int k) { return 3.0 + k; }, [](int /*k*/) { return tolerance; }));
  EXPECT_EQ(bounds[0], 3);
  EXPECT_EQ(bounds[1], 4);
}

TEST(LaggedBounds, TakeNoMoreCallsThanWholeChangesWhereTheseShrink) {
  EXPECT_EQ(calls({0, 0}), 2);
  EXPECT_LE(calls({0.5, 0.5}), 31);  // 2^-30 is the tolerance
  EXPECT_LE(calls({-0.5, -0.5}), 5);
}

/// Whole changes would grow by 30 % each time, as in a wall of 10,026 deformable bricks.
TEST(LaggedBounds, ComeToRestWhereWholeChangesWouldGrow) {
  EXPECT_LE(calls({-1.3, -1.3}), 5);
  EXPECT_LE(calls({-1.3, -0.2}), 25);
}

}  // namespace
}  // namespace blockweir::solid::lagged_bounds_test
