// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// What Shi's scheme takes from a swing: a pendulum on a hinge loses its amplitude as exp(-omega^2 dt t/4).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid::swing_damping_test {
namespace {

constexpr double gravity = 9.81;
constexpr double arm_m = 1;                                       // from the hinge to the centroid
constexpr double radius2_m2 = arm_m * arm_m + (0.16 + 4.0) / 12;  // of gyration about the hinge
constexpr double omega2 = gravity * arm_m / radius2_m2;           // 1/s2

/// Amplitude after 10 s over that of the start, of a bar of 2 m that hangs from its upper end.
double amplitude_left(const char* integrator, double step_s) {
  const double spin = 0.1 * std::sqrt(omega2);
  const auto scene = scene::read_text(fmt::format(R"([analysis]
duration_s = 10
step_s = {}
integrator = "{}"
start = "unstressed"
rigid = "all"
max_displacement_ratio = 0.05
[material.m]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[[block]]
name = "p"
material = "m"
vertices_m = [[-0.2, -2], [0.2, -2], [0.2, 0], [-0.2, 0]]
initial_velocity_m_per_s = [{}, 0]
initial_spin_deg_per_s = {}
[[support]]
block = "p"
point_m = [0, 0]
displacement_x_m = 0
displacement_y_m = 0
)",
                                                  step_s, integrator, spin * arm_m, spin * 180 / 3.141592653589793),
                                      "swing")
                         .scene;
  Solid solid(scene);
  solid.settle({});
  for (long n = 0; static_cast<double>(n) * step_s < scene.analysis.duration_s - 1e-9; ++n) {
    solid.advance(static_cast<double>(n) * step_s, static_cast<double>(n + 1) * step_s, {});
  }
  const double turn = solid.states()[0].displacement[2];
  const double energy = radius2_m2 * std::pow(solid.velocity(0)[2], 2) / 2 + gravity * arm_m * (1 - std::cos(turn));
  return std::sqrt(energy / (radius2_m2 * spin * spin / 2));
}

TEST(SwingDamping, OfShisSchemeIsAQuarterOfTheSquareOfTheFrequencyTimesTheStep) {
  for (const double step_s : {0.02, 0.01}) {
    const double left = amplitude_left("shi", step_s);
    EXPECT_NEAR(std::log(left) / (-omega2 * step_s * 10 / 4), 1, 0.05) << "steps of " << step_s << " s: " << left;
  }
}

TEST(SwingDamping, OfTheTrapezoidalRuleIsNone) {
  EXPECT_NEAR(amplitude_left("trapezoidal", 0.01), 1, 1e-3);
}

}  // namespace
}  // namespace blockweir::solid::swing_damping_test
