// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// A rigid block on shaken ground: the sine pulse from which on it overturns without coming down first, against an
// integration of Housner's equation that shares no code with the program.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::rocking_test {
namespace {

constexpr double gravity = 9.81;

/// A block of width 2 R sin(alpha) and height 2 R cos(alpha), under a_p sin(omega t + psi), which starts as the block
/// lifts, a_p sin(psi) = g tan(alpha), and ends with the sine's period.
struct Pulse {
  double alpha;     ///< rad
  double radius_m;  ///< R
  double omega;     ///< rad/s

  [[nodiscard]] double p() const { return std::sqrt(3 * gravity / (4 * radius_m)); }
  [[nodiscard]] double phase(double amplitude) const { return std::asin(gravity * std::tan(alpha) / amplitude); }
  [[nodiscard]] double end_s(double amplitude) const { return (2 * std::numbers::pi - phase(amplitude)) / omega; }
  [[nodiscard]] double at(double amplitude, double time_s) const {
    return time_s < end_s(amplitude) ? amplitude * std::sin(omega * time_s + phase(amplitude)) : 0;
  }
};

/// Does the block pass twice its slenderness before it comes down? th'' = p^2 (a/g cos(alpha - th) - sin(alpha - th)),
/// or its form for small angles, by Runge and Kutta's rule.
bool equation_overturns(const Pulse& pulse, double amplitude, bool small_angles) {
  constexpr double step_s = 1e-4;
  const double p2 = pulse.p() * pulse.p();
  const auto rate = [&](double time_s, const std::array<double, 2>& y) -> std::array<double, 2> {
    const double a = pulse.at(amplitude, time_s) / gravity;
    const double left = pulse.alpha - y[0];
    return {y[1], p2 * (small_angles ? a - left : a * std::cos(left) - std::sin(left))};
  };
  const auto moved = [](const std::array<double, 2>& y, double by, const std::array<double, 2>& k) {
    return std::array{y[0] + by * k[0], y[1] + by * k[1]};
  };
  std::array<double, 2> y{0, 0};
  for (double t = 0; y[0] < 2 * pulse.alpha; t += step_s) {
    const auto k1 = rate(t, y);
    const auto k2 = rate(t + step_s / 2, moved(y, step_s / 2, k1));
    const auto k3 = rate(t + step_s / 2, moved(y, step_s / 2, k2));
    const auto k4 = rate(t + step_s, moved(y, step_s, k3));
    for (std::size_t i = 0; i < 2; ++i) y[i] += step_s / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    if (y[0] < 0) return false;
  }
  return true;
}

bool blocks_overturn(const Pulse& pulse, double amplitude, scene::BaseForm form, scene::Integrator integrator) {
  auto scene = empty_scene();
  const Point half = pulse.radius_m * Point(std::sin(pulse.alpha), std::cos(pulse.alpha));
  add(scene, {{-half.x(), 0}, {half.x(), 0}, {half.x(), 2 * half.y()}, {-half.x(), 2 * half.y()}});
  add(scene, {{-20, -1}, {20, -1}, {20, 0}, {-20, 0}}, /*fixed=*/true);
  scene.blocks[0].rigid = true;
  scene.default_joint.friction_angle_deg = 80;  // it does not slide
  scene.analysis.step_s = 1e-3;
  scene.analysis.max_displacement_ratio = 0.5;
  scene.analysis.integrator = integrator;
  scene.base_motion.emplace();
  scene.base_motion->form = form;
  scene::TimeTable& rows = scene.base_motion->acceleration_x_m_per_s2;
  rows = {};
  for (int i = 0; i * 1e-3 < pulse.end_s(amplitude) + 1e-3; ++i) {
    rows.time_s.push_back(i * 1e-3);
    rows.value.push_back(-pulse.at(amplitude, i * 1e-3));  // to the left: it leans to the right
  }
  rows.value.back() = 0;
  Solid solid(scene);
  solid.settle({});
  double tilt = 0;
  for (int n = 0; tilt < 2 * pulse.alpha; ++n) {
    solid.advance(n * 1e-3, (n + 1) * 1e-3, {});
    const double before = tilt;
    tilt = -solid.states()[0].displacement[2];
    constexpr double down = 1e-4;
    if (before > down && tilt <= down) return false;
    if (n > 20'000) return false;
  }
  return true;
}

/// Least amplitude that overturns, over g tan(alpha).
double threshold(const Pulse& pulse, const std::function<bool(double amplitude)>& overturns) {
  const double unit = gravity * std::tan(pulse.alpha);
  double stands = 5;
  double falls = 10;
  EXPECT_FALSE(overturns(stands * unit));
  EXPECT_TRUE(overturns(falls * unit));
  while (falls - stands > 1e-3) {
    const double middle = (stands + falls) / 2;
    (overturns(middle * unit) ? falls : stands) = middle;
  }
  return falls;
}

/// After Zhang and Makris (2001): 7.17 of a slender block at omega/p = 5.
TEST(Rocking, HousnersEquationHasThePublishedThreshold) {
  Pulse slender{.alpha = 0.01, .radius_m = 2};
  slender.omega = 5 * slender.p();
  EXPECT_NEAR(threshold(slender, [&](double a) { return equation_overturns(slender, a, true); }), 7.17, 0.01);
}

TEST(Rocking, ABlockOverturnsWithoutAnImpactFromThatPulseOn) {
  for (const double ratio : {4.0, 5.0}) {
    Pulse pulse{.alpha = std::atan(0.2), .radius_m = std::hypot(0.5, 2.5)};
    pulse.omega = ratio * pulse.p();
    const double expected = threshold(pulse, [&](double a) { return equation_overturns(pulse, a, false); });
    for (const auto form : {scene::BaseForm::inertia, scene::BaseForm::support}) {
      for (const auto integrator : {scene::Integrator::shi, scene::Integrator::generalized_alpha}) {
        const double found = threshold(pulse, [&](double a) { return blocks_overturn(pulse, a, form, integrator); });
        EXPECT_NEAR(found, expected, 0.02 * expected);
        std::printf("omega/p %g, form %d, integrator %d: %.4f g tan(alpha), Housner %.4f\n", ratio,
                    static_cast<int>(form), static_cast<int>(integrator), found, expected);
      }
    }
  }
}

}  // namespace
}  // namespace blockweir::solid::rocking_test
