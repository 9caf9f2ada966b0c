// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// The acceleration of a run from its displacements.
#include "solid/watch/acceleration_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blockweir::solid::acceleration_fit_test {
namespace {

double fitted(double ringing_m) {
  AccelerationFit fit;
  std::vector<BlockState> states(1);
  for (int n = 0; n <= 300; ++n) {
    const double t = n * 1e-3;
    states[0].displacement[0] = 1 + 0.2 * t + 0.3 * t * t + ringing_m * std::sin(2 * M_PI * 100 * t);
    states[0].displacement[1] = -0.4 * t * t;
    fit.add(t, states);
  }
  return fit.of(0);
}

TEST(AccelerationFit, IsExactForConstantAcceleration) {
  EXPECT_NEAR(fitted(0), 1, 1e-10);
}

TEST(AccelerationFit, RingingCancels) {
  EXPECT_NEAR(fitted(1e-4), 1, 0.01);  // 39 m/s2 of it at the peak
}

TEST(AccelerationFit, TwoTimesSayNothing) {
  AccelerationFit fit;
  const std::vector<BlockState> states(1);
  fit.add(0, states);
  fit.add(1, states);
  EXPECT_TRUE(std::isnan(fit.of(0)));
}

}  // namespace
}  // namespace blockweir::solid::acceleration_fit_test
