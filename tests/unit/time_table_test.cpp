// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene
// What acts in a step: the value at its end, or the mean of rows within.
#include "bridge/scene/time_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blockweir::scene::time_table_test {
namespace {

TEST(TimeTable, AStepWithoutRowsWithinSeesItsEnd) {
  const TimeTable ramp{.time_s = {0, 1, 2}, .value = {0, 10, 0}};
  EXPECT_DOUBLE_EQ(ramp.at({0.2, 0.3}), 3);
  EXPECT_DOUBLE_EQ(ramp.at({0.9, 1.0}), 10);
  EXPECT_DOUBLE_EQ(ramp.at({1.0 + 1e-15, 1.1}), 9);
  EXPECT_DOUBLE_EQ(ramp.at({0.9, 1.0 + 1e-12}), ramp.at(1.0 + 1e-12)) << "a row at the end but for round-off";
}

TEST(TimeTable, AStepSeesTheMeanOfRowsWithin) {
  const TimeTable peak{.time_s = {0, 1, 2}, .value = {0, 10, 0}};
  EXPECT_DOUBLE_EQ(peak.at({0, 2}), 5);
  EXPECT_DOUBLE_EQ(peak.at({0.5, 1.25}), (0.5 * 7.5 + 0.25 * 8.75) / 0.75);
}

TEST(TimeTable, APulseWithinAStepKeepsItsImpulse) {
  const TimeTable pulse{.time_s = {0, 0.501, 0.509}, .value = {0, 100, 0}, .stepwise = true};
  EXPECT_DOUBLE_EQ(pulse.at({0.5, 0.51}), 80);
  double impulse = 0;
  for (int step = 0; step < 100; ++step) impulse += 0.01 * pulse.at({0.01 * step, 0.01 * (step + 1)});
  EXPECT_NEAR(impulse, 0.8, 1e-12);
}

TEST(TimeTable, ASineIsTakenAtTheEnd) {
  TimeTable table{.time_s = {0, 1, 2}, .value = {0, 10, 0}};
  table.sine = Sine{3, 5, 0.7};
  EXPECT_DOUBLE_EQ(table.at({0, 2}), 5 + 3 * std::sin(10.7));
}

}  // namespace
}  // namespace blockweir::scene::time_table_test
