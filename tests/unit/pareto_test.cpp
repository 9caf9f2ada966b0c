// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_validate
// Which runs nobody betters.
#include "bridge/validate/pareto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace blockweir::pareto_test {
namespace {

using namespace blockweir::study;

Point at(double time_s, double error) {
  return {"", "", time_s, error};
}

TEST(Pareto, TheFrontHasWhatNobodyBettersInBoth) {
  const std::vector<Point> points{at(1, 1e-3), at(2, 1e-4), at(3, 1e-3), at(0.5, 1e-2), at(4, 1e-4)};
  EXPECT_THAT(front(points), testing::ElementsAre(3, 0, 1));
}

TEST(Pareto, WhatIsBetteredIsSoClearly) {
  EXPECT_TRUE(betters(at(1, 1e-3), at(1.2, 1e-3)));
  EXPECT_FALSE(betters(at(1, 1e-3), at(1.05, 1e-3)));
  EXPECT_TRUE(betters(at(1, 1e-4), at(1, 1e-3)));
  EXPECT_FALSE(betters(at(1, 1e-4), at(0.9, 1e-3)));
  EXPECT_FALSE(betters(at(1, 1e-15), at(1, 1e-13))) << "both are round-off";
  EXPECT_TRUE(betters(at(1, 1e-15), at(1, 1e-11)));
}

}  // namespace
}  // namespace blockweir::pareto_test
