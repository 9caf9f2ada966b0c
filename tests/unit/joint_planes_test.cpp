// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Joints that the scene states pair by pair, along one plane: what slides on to a new neighbour keeps the plane's law.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"
#include "tests/samples.hpp"

namespace blockweir::solid::joint_planes_test {
namespace {

std::string block(const std::string& name, double from_m, double to_m, double low_m, double high_m, bool fixed) {
  return fmt::format(
      "[[block]]\nname = \"{}\"\nmaterial = \"rock\"\n{}vertices_m = [[{}, {}], [{}, {}], [{}, {}], [{}, {}]]\n", name,
      fixed ? "fixed = true\n" : "rigid = true\n", from_m, low_m, to_m, low_m, to_m, high_m, from_m, high_m);
}

std::string joint(const std::string& a, const std::string& b, double angle_deg) {
  return fmt::format("[[joints]]\nname = \"{0} on {1}\"\nbetween = [\"{0}\", \"{1}\"]\nfriction_angle_deg = {2}\n", a,
                     b, angle_deg);
}

/// Ground of pieces of 1 m in a row, whose slope is `tilt_deg`; a block of 1 m stands on the first.
std::string slope(double tilt_deg, double duration_s, double friction_elsewhere_deg) {
  std::string text = fmt::format(R"(
[analysis]
duration_s = {}
step_s = 0.002
gravity_tilt_deg = {}
[material.rock]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[joint]
friction_angle_deg = {}
)",
                                 duration_s, tilt_deg, friction_elsewhere_deg);
  for (int piece = 0; piece < 8; ++piece) {
    text += block(fmt::format("ground {}", piece), piece, piece + 1, -1, 0, true);
  }
  return text + block("slider", 0, 1, 0, 0.5, false);
}

double way_m(const std::string& scene) {
  const scene::Scene read = scene::read_text(scene, "s.toml", {}).scene;
  Solid solid(read);
  solid.advance(0, solid.scene().analysis.duration_s, {}, {});
  const auto slider = solid.states().size() - 1;
  return solid.states()[slider].displacement[0];
}

double way_m(double tilt_deg, double friction_deg, double time_s) {
  const double tilt = tilt_deg * std::numbers::pi / 180;
  const double mu = std::tan(friction_deg * std::numbers::pi / 180);
  return 9.81 * (std::sin(tilt) - std::cos(tilt) * mu) * time_s * time_s / 2;
}

/// The program's formula is not asked: s = g (sin a - cos a tan phi) t^2 / 2.
TEST(JointPlanes, ABlockKeepsItsPlanesFrictionPastTheBlockThatItStoodOn) {
  std::mt19937 random(25);
  std::uniform_real_distribution<double> angle(5, 25);
  std::uniform_real_distribution<double> other(0, 60);
  for (int scene = 0; scene < test::samples(4); ++scene) {
    const double friction_deg = angle(random);
    const double tilt_deg = friction_deg + angle(random);
    const double time_s = std::sqrt(3.5 / way_m(tilt_deg, friction_deg, 1));
    const std::string text = slope(tilt_deg, time_s, other(random)) + joint("slider", "ground 0", friction_deg);
    EXPECT_NEAR(way_m(text), way_m(tilt_deg, friction_deg, time_s), 3.5e-3) << text;
  }
}

TEST(JointPlanes, NeighboursThatTouchAndAreNotNamedHaveTheDefaultLaw) {
  std::string text = slope(30, 1, 20);
  const auto at = text.rfind(block("slider", 0, 1, 0, 0.5, false));
  text = text.substr(0, at) + block("slider", 0, 2, 0, 0.5, false) + joint("slider", "ground 0", 15);
  const scene::Scene read = scene::read_text(text, "s.toml", {}).scene;
  const Solid solid(read);
  const int slider = 8;
  EXPECT_NE(solid.laws().between(slider, 0), 0);
  EXPECT_EQ(solid.laws().of_contact(slider, solid.laws().plane_of(0, 2, 0, 1), {1, 2, 0}), 0);
}

/// A block that falls from above onto ground on which something else has a joint has not come along its plane.
TEST(JointPlanes, ALongGroundIsNoPlaneBesideItsJoint) {
  const std::string text =
      slope(0, 1, 20) + block("far", 10, 30, -1, 0, true) + block("dam", 20, 24, 0, 3, false) + joint("dam", "far", 45);
  const scene::Scene read = scene::read_text(text, "s.toml", {}).scene;
  const Solid solid(read);
  EXPECT_EQ(solid.laws().plane_of(9, 2, 0, 1), 0);
  EXPECT_NE(solid.laws().plane_of(10, 0, 0, 1), 0);
}

/// It had the friction of the ledge's plane for the rest of the run, from its own face on the ground's edges and from
/// the ground's corners on its face. So long as it slides in the plane's line, it has it.
TEST(JointPlanes, WhatFallsOffItsPlaneHasTheDefaultLawWhereItLands) {
  for (const double drop_m : {0.0, 0.1}) {
    std::string text = slope(0, 1.2, 30);
    text = text.substr(0, text.rfind("[[block]]")) + block("ledge", -3, 0, -1, drop_m, true) +
           block("slider", -1.5, -0.5, drop_m, drop_m + 0.2, false) + "initial_velocity_m_per_s = [4, 0]\n" +
           joint("slider", "ledge", 5);
    const scene::Scene read = scene::read_text(text, "s.toml", {}).scene;
    Solid solid(read);
    int bear = 0;
    for (double time_s = 0; time_s < 1.2; time_s += 0.1) {
      solid.advance(time_s, time_s + 0.1, {}, {});
      for (const ContactPoint& c : solid.contacts()) {
        const auto [ground, slider] = c.pair();
        if (c.state == ContactState::open || slider != 9 || ground >= 8) continue;
        ++bear;
        EXPECT_NEAR(std::atan(solid.laws()[c.law].friction) * 180 / std::numbers::pi, drop_m > 0 ? 30 : 5, 1e-9)
            << "at " << time_s << " s on piece " << ground << ", " << drop_m << " m below";
      }
    }
    EXPECT_GT(bear, 10) << drop_m;
  }
}

}  // namespace
}  // namespace blockweir::solid::joint_planes_test
