// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// A block with strain that slides with friction goes as far as a rigid one, whatever the step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::sliding_test {
namespace {

constexpr double water_n_per_m3 = 9810;
constexpr double first_level_m = 18.256010529554377;  // 1.01 times that of failure
constexpr double breadth_m = 12;
constexpr double area_m2 = 150;
constexpr double density_kg_per_m3 = 2400;
const double friction = std::tan(33 * std::numbers::pi / 180);

double level_m(double time_s) {
  return first_level_m - 0.461 * time_s;
}

/// Slip of a rigid dam on its base, by its equation of motion: push less friction under weight less triangular uplift.
double rigid_slip_m(double duration_s) {
  constexpr double dt = 1e-5;
  const double mass = density_kg_per_m3 * area_m2;
  double slip = 0;
  double speed = 0;
  for (double t = 0; t < duration_s; t += dt) {
    const double h = level_m(t + dt / 2);
    const double push = water_n_per_m3 * h * h / 2;
    const double bound = friction * (mass * 9.81 - water_n_per_m3 * h * breadth_m / 2);
    const double next = std::max(0.0, speed + dt * (push - bound) / mass);
    slip += dt * (speed + next) / 2;
    speed = next;
  }
  return slip;
}

scene::Scene dam(double mesh_size_m = 0) {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 30e9, 0.2, density_kg_per_m3});
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 33;
  add(scene, {{-40, -6}, {52, -6}, {52, 0}, {-40, 0}}, true);
  add(scene, {{0, 0}, {breadth_m, 0}, {3, 20}, {0, 20}});
  scene.blocks[1].mesh_size_m = mesh_size_m;
  return scene;
}

/// On the upstream face, and triangular uplift under the base.
std::vector<Panel> water_at(double level) {
  const double deepest = water_n_per_m3 * level;
  return {
      {.block = 1, .edge = 3, .s_from = 1 - level / 20, .s_to = 1, .pressure_from_pa = 0, .pressure_to_pa = deepest},
      {.block = 1, .edge = 0, .s_from = 0, .s_to = 1, .pressure_from_pa = deepest, .pressure_to_pa = 0}};
}

double slip_m(scene::Scene scene, double step_s) {
  constexpr double duration_s = 1.5;
  scene.analysis.step_s = step_s;
  Solid solid(scene);
  solid.settle(water_at(level_m(0)));
  const auto windows = std::lround(duration_s / std::max(step_s, 1e-3));
  const double window = duration_s / static_cast<double>(windows);
  for (long n = 0; n < windows; ++n) {
    const double from = static_cast<double>(n) * window;
    solid.advance(from, from + window, water_at(level_m(from + window / 2)));
  }
  return solid.states()[1].displacement[0];
}

/// Row 11 of the wrong answers: 0.0122 m at 10 ms, 0.534 m at 1 ms, 2.27 m at 0.2 ms.
TEST(Sliding, ADamSlidesAsFarAsARigidOneWhateverTheStep) {
  const double right = rigid_slip_m(1.5);
  EXPECT_NEAR(right, 0.0111, 2e-4);
  for (const auto formulation : {scene::ContactFormulation::augmented_lagrangian,
                                 scene::ContactFormulation::lagrange_multiplier, scene::ContactFormulation::penalty}) {
    for (const double step : {0.01, 0.001, 0.0002, 0.0001}) {
      auto scene = dam();
      scene.contact.formulation = formulation;
      EXPECT_NEAR(slip_m(scene, step) / right, 1, 0.02) << static_cast<int>(formulation) << ", step " << step;
    }
  }
}

TEST(Sliding, NorDoSecondOrderRulesMakeItFlutterAtShortSteps) {
  for (const auto integrator : {scene::Integrator::trapezoidal, scene::Integrator::generalized_alpha}) {
    for (const double step : {0.001, 0.0002}) {
      auto scene = dam();
      scene.analysis.integrator = integrator;
      EXPECT_NEAR(slip_m(scene, step) / rigid_slip_m(1.5), 1, 0.02)
          << static_cast<int>(integrator) << ", step " << step;
    }
  }
}

TEST(Sliding, ADamWithAMeshSlidesAsFar) {
  for (const double step : {0.01, 0.001}) EXPECT_NEAR(slip_m(dam(4), step) / rigid_slip_m(1.5), 1, 0.02) << step;
}

}  // namespace
}  // namespace blockweir::solid::sliding_test
