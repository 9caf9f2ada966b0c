// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_joints
// Pressure and conductance of one channel, a wedge of water, against closed forms.
#include "fluid/joints/channel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace blockweir::joints::channel_test {
namespace {

constexpr double mu = 1.3e-3;

TEST(Channel, PressureHasForceAndMomentOfTheWedge) {
  for (const double ratio : {0.001, 0.1, 0.5, 0.97, 0.995, 1.0, 1.00001, 1.01, 1.03, 2.0, 10.0, 1000.0}) {
    const double length = 7;
    const std::array<double, 2> w = {2e-4, 2e-4 * ratio};
    const double p1 = 8e4;
    const double p2 = 1e4;
    const auto pressure = [&](double s) {
      if (ratio == 1) return p1 + (p2 - p1) * s / length;
      const double here = w[0] + (w[1] - w[0]) * s / length;
      // (w^-2 - w2^-2)/(w1^-2 - w2^-2), without differences of what is nearly equal
      const double share = (w[1] - here) * (w[1] + here) * w[0] * w[0] / ((w[1] - w[0]) * (w[1] + w[0]) * here * here);
      return p2 + (p1 - p2) * share;
    };
    double force = 0;
    double moment = 0;
    const int parts = 4000;
    for (int i = 0; i < parts; ++i) {
      using Gauss = boost::math::quadrature::gauss<double, 10>;
      // Parts as long as the aperture is wide: all of them see as much of the curve.
      const auto end = [&](double t) {
        if (std::abs(ratio - 1) < 0.1) return t * length;
        return (std::pow(ratio, t) - 1) / (ratio - 1) * length;
      };
      const double a = end(double(i) / parts);
      const double b = end(double(i + 1) / parts);
      force += Gauss::integrate(pressure, a, b);
      moment += Gauss::integrate([&](double s) { return s * pressure(s); }, a, b);
    }
    const Profile profile = flowing(length, w, {p1, 0}, {p2, 0}, 9810);
    EXPECT_NEAR(profile.force() / force, 1, 1e-10) << ratio;
    EXPECT_NEAR(profile.moment_about_mouth() / moment, 1, 1e-10) << ratio;
    for (const Profile::Knot& knot : profile.knots()) {
      EXPECT_GE(knot.pressure_pa, p2 * (1 - 1e-12)) << ratio;
      EXPECT_LE(knot.pressure_pa, p1 * (1 + 1e-12)) << ratio;
    }
    const double q = (p1 - p2) * w[0] * w[0] * w[1] * w[1] / (6 * mu * length * (w[0] + w[1]));
    EXPECT_NEAR(conductance(length, w, mu).value * (p1 - p2) / q, 1, 1e-12);
    EXPECT_NEAR(profile.force() / length, p2 + (p1 - p2) * w[0] / (w[0] + w[1]), 1e-10 * p1) << ratio;
  }
}

TEST(Channel, OpenTenToOneAtItsMouthHasTenElevenths) {
  EXPECT_NEAR(flowing(1, {1e-3, 1e-4}, {1e5, 0}, {0, 0}, 9810).force() / 1e5, 10.0 / 11, 1e-12);
  EXPECT_NEAR(flowing(1, {1e-4, 1e-3}, {1e5, 0}, {0, 0}, 9810).force() / 1e5, 1.0 / 11, 1e-12);
}

TEST(Channel, StandingWaterReachesAsHighAsItsPressure) {
  const Profile up = standing(5, {3 * 9810.0, 0}, {0, 4}, 9810);
  EXPECT_NEAR(up.force(), 9810 * 3 * 0.5 * 3 * 5.0 / 4, 1e-8);
  const Profile down = standing(5, {0, 4}, {3 * 9810.0, 0}, 9810);
  EXPECT_NEAR(down.force(), up.force(), 1e-8);
}

}  // namespace
}  // namespace blockweir::joints::channel_test
