// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_block
// Pressures between exchanges of a fluid that divides its edges anew.
#include <gtest/gtest.h>

#include <algorithm>

#include "solid/block/pressure_history.hpp"

namespace blockweir::solid::pressure_history_test {
namespace {

/// Force and moment about its end of what presses on edge 0 of block 0, which is 1 m long.
Point force_and_moment(const std::vector<Panel>& panels) {
  Point sum = Point::Zero();
  for (const Panel& p : panels) {
    const double length = p.s_to - p.s_from;
    sum.x() += length * (p.pressure_from_pa + p.pressure_to_pa) / 2;
    sum.y() += length * (p.pressure_from_pa * (2 * p.s_from + p.s_to) + p.pressure_to_pa * (p.s_from + 2 * p.s_to)) / 6;
  }
  return sum;
}

/// A pressure t (1 + s) in as many panels, the last first where `backwards`.
std::vector<Panel> divided(int count, double time_s, bool backwards = false) {
  std::vector<Panel> panels;
  for (int i = 0; i < count; ++i) {
    const double from = static_cast<double>(i) / count;
    const double to = (i + 1.0) / count;
    panels.push_back({0, 0, from, to, time_s * (1 + from), time_s * (1 + to)});
  }
  if (backwards) std::reverse(panels.begin(), panels.end());
  return panels;
}

TEST(PressureHistory, ForcesGoOnHoweverTheFluidDividesItsEdges) {
  for (const int degree : {1, 2}) {
    PressureHistory course(degree);
    course.add(0.5, divided(4, 0.5));
    course.add(1.0, divided(7, 1.0));
    course.add(1.5, divided(7, 1.5, /*backwards=*/true));
    const Point got = force_and_moment(course.at(2));
    EXPECT_NEAR(got.x(), 2 * 1.5, 1e-12) << degree;
    EXPECT_NEAR(got.y(), 2 * (1 / 2.0 + 1 / 3.0), 1e-12) << degree;
  }
}

TEST(PressureHistory, AnEdgeThatIsWettedAnewHasNoPast) {
  PressureHistory course(1);
  course.add(1, divided(1, 1));
  auto more = divided(1, 2);
  more.push_back({0, 1, 0, 1, 1, 1});
  course.add(2, more);
  EXPECT_EQ(course.weights(3), (PressureHistory::Weights{1, 0, 0}));
}

TEST(PressureHistory, ASurfaceThatRisesGoesOnRising) {
  PressureHistory course(1);
  course.add(1, {{0, 0, 0, 0.25, 100, 0}});
  course.add(2, {{0, 0, 0, 0.50, 200, 0}});
  const Panel on = course.at(3).at(0);
  EXPECT_DOUBLE_EQ(on.s_to, 0.75);
  EXPECT_DOUBLE_EQ(on.pressure_from_pa, 300);
}

}  // namespace
}  // namespace blockweir::solid::pressure_history_test
