// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// The theory of explicit schedules against what their characteristic polynomials give by hand.
#include "solid/watch/schedule_stability.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blockweir::solid::schedule_stability_test {
namespace {

using scene::Integrator;
using scene::LoadInWindow;
using scene::Schedule;

constexpr double round_off = 1e-6;  // a free block's double root at 1 has half the digits

/// A free block against water `ratio` times as heavy.
double growth(double ratio, Schedule schedule, Integrator integrator, LoadInWindow load, bool guarded = false) {
  return schedule_growth({.mass = 2,
                          .added_mass = 2 * ratio,
                          .guarded_mass = guarded ? 2 * ratio : 0,
                          .window_s = 0.1,
                          .integrator = integrator,
                          .schedule = schedule,
                          .load = load});
}

TEST(ScheduleStability, ShisSchemeGrowsByTheMassRatio) {
  // a_n+1 = -r a_n
  EXPECT_NEAR(growth(0.9, Schedule::serial, Integrator::shi, LoadInWindow::held), 1, round_off);
  EXPECT_NEAR(growth(1.1, Schedule::serial, Integrator::shi, LoadInWindow::held), 1.1, round_off);
  EXPECT_NEAR(growth(5, Schedule::serial, Integrator::shi, LoadInWindow::held), 5, round_off);
}

TEST(ScheduleStability, TheTrapezoidalRuleAveragesTwoAccelerations) {
  // z^2 + r/2 z + r/2 = 0, a pair of size sqrt(r/2)
  EXPECT_NEAR(growth(1.9, Schedule::serial, Integrator::trapezoidal, LoadInWindow::held), 1, round_off);
  EXPECT_NEAR(growth(3, Schedule::serial, Integrator::trapezoidal, LoadInWindow::held), std::sqrt(1.5), round_off);
}

TEST(ScheduleStability, PredictionsAndLinesLowerTheLimit) {
  // z^3 + 1.5 r z - r/2 = 0 has a pair of size 1 where r^2/4 + 1.5 r = 1
  const double parallel = std::sqrt(13.0) - 3;
  EXPECT_NEAR(growth(0.99 * parallel, Schedule::parallel, Integrator::trapezoidal, LoadInWindow::held), 1, round_off);
  EXPECT_GT(growth(1.01 * parallel, Schedule::parallel, Integrator::trapezoidal, LoadInWindow::held), 1.001);
  // z^2 + 1.5 r z - r/2 = 0 has -1 at r = 1/2
  EXPECT_NEAR(growth(0.49, Schedule::improved, Integrator::trapezoidal, LoadInWindow::linear), 1, round_off);
  const double r = 0.8;
  EXPECT_NEAR(growth(r, Schedule::improved, Integrator::trapezoidal, LoadInWindow::linear),
              (1.5 * r + std::sqrt(2.25 * r * r + 2 * r)) / 2, round_off);
}

TEST(ScheduleStability, WithTheGuardNothingGrowsUpToAHundred) {
  for (const Schedule schedule : {Schedule::serial, Schedule::parallel, Schedule::improved}) {
    for (const Integrator integrator : {Integrator::shi, Integrator::trapezoidal}) {
      for (const LoadInWindow load : {LoadInWindow::held, LoadInWindow::linear, LoadInWindow::quadratic}) {
        for (const double ratio : {0.5, 2.0, 10.0, 100.0}) {
          EXPECT_LT(growth(ratio, schedule, integrator, load, true), 1 + 1e-4) << ratio;
        }
      }
    }
  }
}

TEST(ScheduleStability, TheGuardMayGuessTooLowByWhatTheScheduleCarries) {
  // What stays late is (1 - g) r of 1 + g r.
  const auto grows = [](Schedule schedule, LoadInWindow load, double guess) {
    const double ratio = 100;
    return schedule_growth({.mass = 1,
                            .added_mass = ratio,
                            .guarded_mass = guess * ratio,
                            .window_s = 0.1,
                            .schedule = schedule,
                            .load = load}) > 1 + round_off;
  };
  EXPECT_TRUE(grows(Schedule::serial, LoadInWindow::held, 0.49));
  EXPECT_FALSE(grows(Schedule::serial, LoadInWindow::held, 0.51));
  EXPECT_TRUE(grows(Schedule::serial, LoadInWindow::linear, 0.74));
  EXPECT_FALSE(grows(Schedule::serial, LoadInWindow::linear, 0.76));
  EXPECT_TRUE(grows(Schedule::parallel, LoadInWindow::held, 0.70));
  EXPECT_FALSE(grows(Schedule::parallel, LoadInWindow::held, 0.72));
  EXPECT_TRUE(grows(Schedule::improved, LoadInWindow::linear, 0.79));
  EXPECT_FALSE(grows(Schedule::improved, LoadInWindow::linear, 0.81));
}

}  // namespace
}  // namespace blockweir::solid::schedule_stability_test
