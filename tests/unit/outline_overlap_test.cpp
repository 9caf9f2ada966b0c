// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// How far two outlines are in each other.
#include "solid/contact/outline_overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blockweir::solid::outline_overlap_test {
namespace {

const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(OutlineOverlap, OfACornerIsItsDistanceFromTheOthersSides) {
  EXPECT_NEAR(overlap_m(square, {{0.9, 0.5}, {2, 0}, {2, 1}}, 0), 0.1, 1e-12);
  EXPECT_NEAR(overlap_m({{0.9, 0.5}, {2, 0}, {2, 1}}, square, 0), 0.1, 1e-12);
}

TEST(OutlineOverlap, OfNeedlesThatCrossIsSeenThoughNoCornerIsInside) {
  const std::vector<Point> across = {{-1, 0.4}, {2, 0.4}, {2, 0.6}, {-1, 0.6}};
  EXPECT_NEAR(overlap_m({{0.45, -1}, {0.55, -1}, {0.55, 2}, {0.45, 2}}, across, 0), 0.1, 1e-12);
}

TEST(OutlineOverlap, OfWhatTouchesOrLiesInANotchIsNone) {
  EXPECT_EQ(overlap_m(square, {{1, 0.2}, {2, 0.2}, {2, 0.8}, {1, 0.8}}, 0), 0);
  const std::vector<Point> hollow = {{-1, -1}, {2, -1}, {2, 2}, {1.1, 2}, {1.1, -0.1}, {-1, -0.1}};
  EXPECT_EQ(overlap_m(square, hollow, 0), 0);
}

TEST(OutlineOverlap, OfLessThanIsKnownIsNotLookedFor) {
  EXPECT_EQ(overlap_m(square, {{0.9, 0.5}, {2, 0}, {2, 1}}, 0.2), 0.2);
}

TEST(OutlineOverlap, OfATipInAFootIsTheShiftThatPartsThem) {
  const std::vector<Point> wedge = {{0.9, 0}, {2, 0}, {2, 1}};
  EXPECT_NEAR(parting_shift_m(square, wedge, 0), 0.1 / std::hypot(1.1, 1), 1e-12);
  EXPECT_NEAR(parting_shift_m(wedge, square, 0), 0.1 / std::hypot(1.1, 1), 1e-12);
  EXPECT_EQ(parting_shift_m(square, {{1, 0}, {2, 0}, {2, 1}}, 0), 0);
  EXPECT_EQ(parting_shift_m(square, wedge, 0.2), 0.2);
  const std::vector<Point> hollow = {{-1, -1}, {2, -1}, {2, 2}, {1.1, 2}, {1.1, -0.1}, {-1, -0.1}};
  EXPECT_EQ(parting_shift_m(square, hollow, 0), 0);
}

}  // namespace
}  // namespace blockweir::solid::outline_overlap_test
