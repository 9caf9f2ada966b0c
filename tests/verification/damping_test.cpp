// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Damping of strains by their ratio, and of motion by mass.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "bridge/geometry/polygon.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::damping_test {
namespace {

/// Largest strain of a free bar under suddenly applied end forces, over the strain at rest.
double overshoot(double damping_ratio, double mass_damping_per_s) {
  auto scene = empty_scene();
  scene.materials[0].poissons_ratio = 0;
  scene.materials[0].damping_ratio = damping_ratio;
  scene.analysis.plane = scene::Plane::stress;
  scene.analysis.integrator = scene::Integrator::trapezoidal;
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.mass_damping_per_s = mass_damping_per_s;
  add(scene, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
  const double omega = std::sqrt(12 * 50e9 / 2500) / 4;  // strain mode of the bar, E A over density I
  scene.analysis.step_s = 2 * std::numbers::pi / omega / 400;
  for (const double x : {0.0, 4.0}) {
    scene::PointLoad load{.block = 0, .point_m = Point(x, 0.5)};
    load.force_x_n_per_m = scene::TimeTable::constant(x == 0 ? -1e6 : 1e6);
    load.force_y_n_per_m = scene::TimeTable::constant(0);
    scene.point_loads.push_back(load);
  }
  Solid solid(scene);
  double largest = 0;
  for (int n = 0; n < 400; ++n) {
    const double dt = scene.analysis.step_s;
    solid.advance(n * dt, (n + 1) * dt, {});
    largest = std::max(largest, solid.states()[0].displacement[3]);
  }
  return largest / (1e6 / 50e9);
}

TEST(Damping, IsWhatItsRatioSays) {
  for (const double zeta : {0.0, 0.02, 0.1, 0.3}) {
    const double expected = 1 + std::exp(-std::numbers::pi * zeta / std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(overshoot(zeta, 0), expected, 1e-3 * expected) << zeta;
    const double omega = std::sqrt(12 * 50e9 / 2500) / 4;
    EXPECT_NEAR(overshoot(0, 2 * zeta * omega), expected, 1e-3 * expected) << zeta;
  }
}

TEST(Damping, AFallingBlockComesToItsTerminalSpeedUnderMassDamping) {
  auto scene = empty_scene();
  scene.analysis.mass_damping_per_s = 3;
  scene.analysis.max_displacement_ratio = 100;
  scene.materials[0].damping_ratio = 0.1;  // rigid motion does not feel it
  add(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  Solid solid(scene);
  run(solid, 10);
  EXPECT_NEAR(solid.states()[0].velocity[1], -9.81 / 3, 1e-9);
}

}  // namespace
}  // namespace blockweir::solid::damping_test
