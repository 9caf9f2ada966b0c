// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// What lands on the move loses the friction of the impulse that stops its fall, once: u+ = u- - mu v, whatever the
// step, the integrator and where in the step it lands (Moreau 1999, for a block that lands flat).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::impact_friction_test {
namespace {

struct Landing {
  double speed_m_per_s;
  double height_m;
  double friction;
  [[nodiscard]] double fall_m_per_s() const { return std::sqrt(2 * 9.81 * height_m); }
  /// Level speed once it has landed; 0: it sticks.
  [[nodiscard]] double goes_on_m_per_s() const { return std::max(0.0, speed_m_per_s - friction * fall_m_per_s()); }
};

double speed_after(const Landing& landing, scene::Integrator integrator, bool rigid, double step_s) {
  scene::Scene scene = empty_scene();
  scene.analysis.start = scene::Start::unstressed;
  scene.analysis.max_displacement_ratio = 0.5;
  scene.analysis.rigid = rigid ? scene::Rigid::all : scene::Rigid::none;
  scene.analysis.integrator = integrator;
  scene.analysis.step_s = step_s;
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg =
      std::atan(landing.friction) * 180 / std::numbers::pi;
  add(scene, {{-10, -2}, {60, -2}, {60, 0}, {-10, 0}}, true);
  const double h = landing.height_m;
  add(scene, {{0, h}, {4, h}, {4, h + 1}, {0, h + 1}});
  scene.blocks[1].initial_velocity_m_per_s = {landing.speed_m_per_s, 0};
  Solid solid(scene);
  const double lands_s = landing.fall_m_per_s() / 9.81;
  const double ends_s = lands_s + 20 * step_s;
  for (double t = 0; t < ends_s; t += step_s) solid.advance(t, t + step_s, {});
  const double slid_s = solid.time_s() - lands_s;
  const double speed = solid.states()[1].velocity[0];
  return speed > 0 ? speed + landing.friction * 9.81 * slid_s : 0;  // as it was just after
}

TEST(ImpactFriction, IsThatOfTheImpulseThatStopsTheFall) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  constexpr std::array integrators = {scene::Integrator::shi, scene::Integrator::trapezoidal,
                                      scene::Integrator::generalized_alpha};
  for (int draw = 0; draw < 12; ++draw) {
    const Landing landing{1 + 4 * share(random), 0.05 + share(random), 0.1 + 0.6 * share(random)};
    const double step_s = 1e-3 * (0.5 + share(random));
    for (const auto integrator : integrators) {
      const double expected = landing.goes_on_m_per_s();
      const double tolerance = 3 * 9.81 * step_s;  // of falls through the steps about the landing
      EXPECT_NEAR(speed_after(landing, integrator, true, step_s), expected, tolerance)
          << "draw " << draw << ", integrator " << static_cast<int>(integrator) << ", friction " << landing.friction;
    }
  }
}

TEST(ImpactFriction, OfABlockThatStrainsIsTheSame) {
  const Landing landing{3, 0.2, 0.15};
  EXPECT_NEAR(speed_after(landing, scene::Integrator::shi, false, 5e-4), landing.goes_on_m_per_s(), 0.03);
}

}  // namespace
}  // namespace blockweir::solid::impact_friction_test
