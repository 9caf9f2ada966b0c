// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// How a step is tried.
#include "solid/step/step_mode.hpp"

#include <gtest/gtest.h>

namespace blockweir::solid::step_mode_test {
namespace {

TEST(StepMode, IsInMotionWhereItsIntegratorHasVelocities) {
  EXPECT_TRUE(StepMode{}.in_motion());
  EXPECT_FALSE((StepMode{.scheme = {.damps = false}}.in_motion()));
}

TEST(StepMode, OneMethodMoreLeavesAllElseAsItWas) {
  const StepMode own{.scheme = {.damps = false}, .settles = true};
  const StepMode lagging = own.with_lagging_friction();
  EXPECT_TRUE(lagging.friction_lags);
  EXPECT_TRUE(lagging.settles);
  EXPECT_TRUE(lagging.scheme == own.scheme);
  EXPECT_FALSE(own.friction_lags);
  EXPECT_FALSE(lagging.by_whole_law().friction_lags);
  EXPECT_TRUE(own.with_pivoting().pivots);
  EXPECT_FALSE(own.with_pivoting().sweeps);
  EXPECT_TRUE(own.with_sweeps().sweeps);
}

}  // namespace
}  // namespace blockweir::solid::step_mode_test
