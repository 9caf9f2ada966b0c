// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
#include "bridge/picture/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace blockweir::picture::response_spectrum_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(ResponseSpectrum, GroundThatStartsToAccelerateOvershootsByItsDamping) {
  const auto steady = scene::TimeTable::constant(2);
  for (const double zeta : {0.0, 0.05, 0.2}) {
    const double overshoot = 1 + std::exp(-zeta * pi / std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(pseudo_acceleration(steady, 5, 0.8, zeta), 2 * overshoot, 2e-3) << zeta;
  }
}

TEST(ResponseSpectrum, StiffOscillatorsFeelTheGroundAndSoftOnesStay) {
  scene::TimeTable pulse;
  for (int i = 0; i <= 400; ++i) {
    pulse.time_s.push_back(i / 400.0);
    pulse.value.push_back(3 * std::sin(pi * i / 400));
  }
  EXPECT_NEAR(pseudo_acceleration(pulse, 1, 0.02, 0.05), 3, 0.02);
  EXPECT_LT(pseudo_acceleration(pulse, 1, 30, 0.05), 0.5);
  // Undamped and of the pulse's length: x = (sin wt/2 - sin(wt)/2) 4/3 is largest at a third of a turn.
  EXPECT_NEAR(pseudo_acceleration(pulse, 1, 1.0, 0), 3 * std::sqrt(3), 0.01);
}

}  // namespace
}  // namespace blockweir::picture::response_spectrum_test
