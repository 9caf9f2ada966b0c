// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit bridge_scene_read
// Limit analysis of corners that meet edges, and of ground with corners.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "bridge/scene/read/read.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/limit/limit_strength.hpp"

namespace blockweir::limit_corners_test {
namespace {

using namespace blockweir::solid::limit;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

scene::Scene read(const std::string& text) {
  return scene::read_text(text, "test.toml").scene;
}

/// A ladder against a wall: two corners on two edges and no face. At its limit both corners slide, and with G the
/// middle of the ladder x_G (1 + m^2) = m y_B + m^2 x_B, m the reduced friction, counted from the foot.
TEST(LimitCorners, ALadderIsHeldByItsCorners) {
  for (const auto& [slope_deg, friction_deg, thickness] :
       {std::tuple{60.0, 35.0, 0.2}, {45.0, 20.0, 0.01}, {75.0, 50.0, 1.0}}) {
    const Point along(std::cos(radians(slope_deg)), std::sin(radians(slope_deg)));
    const Point top = 5 * along;
    const Point across = thickness * Point(-along.y(), along.x());
    const scene::Scene scene =
        read(fmt::format("analysis.duration_s = 1\njoint.friction_angle_deg = {0}\n"
                         "material.m = {{youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2000}}\n"
                         "[[block]]\nname = 'rock'\nmaterial = 'm'\nfixed = true\n"
                         "vertices_m = [[-9, -1], [{1}, -1], [{1}, 0], [-9, 0]]\n"
                         "[[block]]\nname = 'wall'\nmaterial = 'm'\nfixed = true\n"
                         "vertices_m = [[{1}, 0], [{2}, 0], [{2}, 9], [{1}, 9]]\n"
                         "[[block]]\nname = 'ladder'\nmaterial = 'm'\n"
                         "vertices_m = [[0, 0], [{1}, {3}], [{4}, {5}], [{6}, {7}]]\n",
                         friction_deg, top.x(), top.x() + 1, top.y(), top.x() + across.x(), top.y() + across.y(),
                         across.x(), across.y()));
    const double middle = (top.x() + across.x()) / 2;
    const double needed = 2 * middle / (top.y() + std::sqrt(top.y() * top.y() - 4 * (middle - top.x()) * middle));
    const LimitStrength found = limit_strength(LimitAnalysis(scene), statics::weights_of(scene));
    ASSERT_EQ(found.bearing, Bearing::fails_at_a_factor);
    EXPECT_NEAR(found.factor / (std::tan(radians(friction_deg)) / needed), 1, 1e-8) << slope_deg;
    EXPECT_LT(found.gap, 1e-8);
  }
}

/// A wall on a joint that dips to level rock at its toe. `ledge`: length of a level joint at the toe.
scene::Scene on_a_dip(double dip, double breadth, double friction_deg, double push, double ledge) {
  return read(
      fmt::format("analysis.duration_s = 1\njoint.friction_angle_deg = {0}\n"
                  "material.m = {{youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2300}}\n"
                  "[[body_load]]\nblocks = ['wall']\nacceleration_x_m_per_s2 = {1}\n"
                  "[[block]]\nname = 'rock'\nmaterial = 'm'\nfixed = true\n"
                  "vertices_m = [[-9, -4], [14, -4], [14, {2}], [{3}, {2}], [0, 0], [-9, 0]]\n"
                  "[[block]]\nname = 'wall'\nmaterial = 'm'\nvertices_m = [[0, 0], [{3}, {2}], {4}[2, 5], [0, 5]]\n",
                  friction_deg, push, -dip * breadth, breadth,
                  ledge == 0 ? "" : fmt::format("[{}, {}], ", breadth + ledge, -dip * breadth)));
}

/// In a point as on a ledge of next to no length.
TEST(LimitCorners, ACornerInAReflexCornerOfTheGroundIsHeldByBothItsEdges) {
  std::mt19937 random(25);
  const auto between = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  for (int i = 0; i < 20; ++i) {
    const double dip = between(0.02, 0.5);
    const double breadth = between(2.5, 5);
    const double friction_deg = between(20, 50);
    const double push = between(0.5, 3);
    const auto factor = [&](double ledge) {
      const scene::Scene scene = on_a_dip(dip, breadth, friction_deg, push, ledge);
      const Wrenches loads = combined(statics::weights_of(scene), 1, statics::stated_loads_of(scene, 1));
      return limit_strength(LimitAnalysis(scene), loads).factor;
    };
    EXPECT_NEAR(factor(0) / factor(1e-4), 1, 1e-3) << i;
  }
}

/// A wall on a dip; at its toe the ground goes on level, or higher and against the toe, or away. `cut_x`: where the
/// ground is drawn as two blocks, at the toe or beneath the wall.
scene::Scene on_ground_of(double dip, double breadth, double beyond, double push, const std::optional<double>& cut_x) {
  const double toe = -dip * breadth;
  const auto block = [](const std::string& name, const std::string& vertices) {
    return fmt::format("[[block]]\nname = '{}'\nmaterial = 'm'\nfixed = true\nvertices_m = [{}]\n", name, vertices);
  };
  const std::string right = fmt::format("[14, -9], [14, {}], [{}, {}]", beyond, breadth, toe);
  const double x = cut_x.value_or(0);
  const std::string cut_at = fmt::format("[{}, {}]", x, -dip * x);
  const std::string top = x < breadth ? ", " + cut_at : "";
  const std::string ground = cut_x ? block("left", fmt::format("[-9, -9], [{}, -9], {}, [0, 0], [-9, 0]", x, cut_at)) +
                                         block("right", fmt::format("[{}, -9], {}{}", x, right, top))
                                   : block("rock", fmt::format("[-9, -9], {}, [0, 0], [-9, 0]", right));
  return read(
      fmt::format("analysis.duration_s = 1\njoint.friction_angle_deg = 35\n"
                  "material.m = {{youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2300}}\n"
                  "[[body_load]]\nblocks = ['wall']\nacceleration_x_m_per_s2 = {}\n{}"
                  "[[block]]\nname = 'wall'\nmaterial = 'm'\n"
                  "vertices_m = [[0, 0], [{}, {}], [2, 5], [0, 5]]\n",
                  push, ground, breadth, toe));
}

TEST(LimitCorners, GroundDrawnAsOneBlockOrAsTwoHoldsAlike) {
  std::mt19937 random(4);
  const auto between = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  for (int i = 0; i < 30; ++i) {
    const double dip = between(0.02, 0.5);
    const double breadth = between(2.5, 5);
    const double beyond = between(-6, 4);
    const double push = between(0.5, 3);
    const auto strength = [&](const std::optional<double>& cut_x) {
      const scene::Scene scene = on_ground_of(dip, breadth, beyond, push, cut_x);
      return limit_strength(LimitAnalysis(scene),
                            combined(statics::weights_of(scene), 1, statics::stated_loads_of(scene, 1)));
    };
    const LimitStrength one = strength({});
    for (const double cut_x : {breadth, between(0.1, 0.9) * breadth}) {
      const LimitStrength two = strength(cut_x);
      ASSERT_EQ(two.bearing, one.bearing) << i;
      EXPECT_NEAR(two.factor, one.factor, 1e-7 * one.factor) << i;
    }
  }
}

}  // namespace
}  // namespace blockweir::limit_corners_test
