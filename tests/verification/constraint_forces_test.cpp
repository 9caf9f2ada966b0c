// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// What holds or leads a moving block presses it as its acceleration has it, whatever the integrator and the step.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid::constraint_forces_test {
namespace {

constexpr double density = 2300;
constexpr double g = 9.81;

struct Way {
  const char* integrator;
  double step_s;
};

std::string start(const Way& way, double friction_deg) {
  return fmt::format(R"([analysis]
duration_s = 2
step_s = {}
integrator = "{}"
rigid = "all"
start = "unstressed"
[joint]
friction_angle_deg = {}
[material.m]
youngs_modulus_pa = 1e10
poissons_ratio = 0.2
density_kg_per_m3 = {}
)",
                     way.step_s, way.integrator, friction_deg, density);
}

std::string block(const std::string& name, const std::string& vertices, const std::string& more = "") {
  return fmt::format("[[block]]\nname = \"{}\"\nmaterial = \"m\"\nvertices_m = [{}]\n{}", name, vertices, more);
}

/// On the second block of a contact's pair, in its frame's normal and along it; of a scene with one level joint.
Eigen::Vector2d joint_force(const Solid& solid) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const ContactPoint& c : solid.contacts()) {
    if (c.state != ContactState::open) sum += Eigen::Vector2d(c.force.x(), std::abs(c.force.y()));
  }
  return sum;
}

class ConstraintForces : public testing::TestWithParam<Way> {};

/// A block 0.2 m wide and 1 m high turns on its toe: N = m (g + y''), S = m x'', of its centroid on a circle.
TEST_P(ConstraintForces, OfAToeAreThoseOfACentroidOnACircle) {
  const scene::Scene scene =
      scene::read_text(start(GetParam(), 80) + block("ground", "[-3, -1], [6, -1], [6, 0], [-3, 0]", "fixed = true\n") +
                           block("turns", "[0, 0], [0.2, 0], [0.2, 1], [0, 1]",
                                 "initial_velocity_m_per_s = [0.6, 0.12]\ninitial_spin_deg_per_s = -68.754935415\n"),
                       "toe")
          .scene;
  const double mass = density * 0.2;
  const double r = std::hypot(0.1, 0.5);
  const double inertia = mass * (r * r + (0.04 + 1) / 12);
  const double began = -std::atan2(0.1, 0.5);
  const double energy = inertia * 1.2 * 1.2 / 2 + mass * g * r * std::cos(began);
  Solid solid(scene);
  const double dt = GetParam().step_s;
  int compared = 0;
  for (double t = 0, turned = 0; turned < 0.9; t += dt) {
    const double at_start = -solid.states()[1].displacement[2];
    solid.advance(t, t + dt, {});
    turned = -solid.states()[1].displacement[2];
    const double angle = began + (at_start + turned) / 2;
    const double w2 = 2 * (energy - mass * g * r * std::cos(angle)) / inertia;
    const double turns = mass * g * r * std::sin(angle) / inertia;
    const double normal = mass * (g - r * (turns * std::sin(angle) + w2 * std::cos(angle)));
    const double shear = mass * r * (turns * std::cos(angle) - w2 * std::sin(angle));
    if (turned < 0.05) continue;
    const Eigen::Vector2d force = joint_force(solid);
    ASSERT_NEAR(force.x() / (mass * g), normal / (mass * g), 0.02) << turned;
    ASSERT_NEAR(force.y() / (mass * g), std::abs(shear) / (mass * g), 0.02) << turned;
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

/// x = way (1 - cos 2 pi t), by its formula or in rows that are a step apart.
std::string path(double way_m, double step_s, bool by_rows) {
  if (!by_rows) return fmt::format("{{ sine = {0}, frequency_hz = 1, phase_deg = -90, mean = {0} }}", way_m);
  std::string rows;
  for (int i = 0; i * step_s < 1.6; ++i) {
    rows += fmt::format("[{}, {}], ", i * step_s, way_m * (1 - std::cos(2 * std::numbers::pi * i * step_s)));
  }
  return "{ table = [" + rows + "] }";
}

/// On a driver whose greatest acceleration is 0.6 of what friction gives, a block rides with 0.6 of its friction.
TEST_P(ConstraintForces, OfABlockOnADriverAreItsMassTimesTheAcceleration) {
  const double friction = std::tan(30 * std::numbers::pi / 180);
  const double way_m = 0.6 * friction * g / (4 * std::numbers::pi * std::numbers::pi);
  const double dt = GetParam().step_s;
  for (const bool by_rows : {false, true}) {
    // Straight lines between rows begin with a leap of the velocity, after which the trapezoidal rule rings.
    if (by_rows && GetParam().integrator == std::string("trapezoidal")) continue;
    const scene::Scene scene =
        scene::read_text(
            start(GetParam(), 30) + block("driver", "[0, 0], [6, 0], [6, 1], [0, 1]") +
                block("rides", "[2, 1], [3, 1], [3, 1.3], [2, 1.3]") +
                "[[support]]\nblock = \"driver\"\npoint_m = [0, 0]\ndisplacement_x_m = " + path(way_m, dt, by_rows) +
                "\ndisplacement_y_m = 0\n[[support]]\nblock = \"driver\"\npoint_m = [6, 0]\n"
                "displacement_y_m = 0\n",
            "driver")
            .scene;
    Solid solid(scene);
    double most = 0;
    for (double t = 0; t < 1.5; t += dt) {
      solid.advance(t, t + dt, {});
      if (t > 0.1) most = std::max(most, joint_force(solid).y());
    }
    EXPECT_NEAR(most / (density * 0.3 * friction * g), 0.6, 0.012) << by_rows;
    EXPECT_NEAR(solid.states()[1].displacement[0], solid.states()[0].displacement[0], 1e-6) << "it has slipped";
  }
}

/// Two supports keep a wall upright as they move it to and fro: one corner may bear all, and the other slips with it.
TEST_P(ConstraintForces, NoCornerOfAWallLosesItsSlipWhereTheOtherBearsAll) {
  std::string text = start(GetParam(), 30) + block("bed", "[-20, -4], [20, -4], [20, 0], [-20, 0]", "fixed = true\n") +
                     block("wall", "[0, 0], [4, 0], [4, 8], [0, 8]");
  for (const int y : {2, 6}) {
    text += fmt::format(
        "[[support]]\nblock = \"wall\"\npoint_m = [4, {}]\ndisplacement_x_m = {{ sine = 0.02, frequency_hz = 0.5 }}\n",
        y);
  }
  const scene::Scene scene = scene::read_text(text, "wall").scene;
  Solid solid(scene);
  const double dt = GetParam().step_s;
  for (double t = 0; t < 2; t += dt) {
    solid.advance(t, t + dt, {});
    for (const ContactPoint& c : solid.contacts()) {
      ASSERT_NEAR(std::abs(c.slip_m), std::abs(solid.states()[1].displacement[0]), 1e-9) << t;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, ConstraintForces,
                         testing::Values(Way{"shi", 5e-3}, Way{"shi", 1e-3}, Way{"trapezoidal", 5e-3},
                                         Way{"generalized-alpha", 5e-3}),
                         [](const auto& way) {
                           return fmt::format("{}{}", std::string(way.param.integrator).substr(0, 3), way.index);
                         });

}  // namespace
}  // namespace blockweir::solid::constraint_forces_test
