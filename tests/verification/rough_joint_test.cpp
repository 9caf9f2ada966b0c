// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers bridge_scene_read
// A block on a slope whose joint is rough, after Barton and Bandis, tau = sigma tan(phi + JRC log10(JCS/sigma)): in
// motion, in strength reduction and in limit analysis.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/read/read.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/expect/formula_tables.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid::rough_joint_test {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double roughness = 9;
constexpr double wall_strength_pa = 60e6;

/// A rigid block 4 m x 2 m of density 2500 kg/m3 on a slope under gravity that is tilted by it.
scene::Scene on_a_slope(double slope_deg, const std::string& more = "") {
  const double slope = slope_deg * degree;
  return scene::read_text(
             fmt::format(R"(analysis = {{ duration_s = 0.5, step_s = 0.01, rigid = "all" }}
material.m = {{ youngs_modulus_pa = 50e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }}
joint = {{ friction_angle_deg = 25, roughness = {}, wall_strength_pa = {} }}
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-20, -1], [30, -1], [30, 0], [-20, 0]]
[[block]]
name = "block"
material = "m"
vertices_m = [[0, 0], [4, 0], [4, 2], [0, 2]]
[[body_load]]
blocks = ["block"]
acceleration_x_m_per_s2 = {}
acceleration_y_m_per_s2 = {}
{})",
                         roughness, wall_strength_pa, 9.81 * std::sin(slope), 9.81 * (1 - std::cos(slope)), more),
             "slope.toml")
      .scene;
}

constexpr double weight = 2500 * 9.81 * 8;

/// N/m that half of the base bears, 2 m, under that normal force.
double bears(double normal) {
  return normal * std::tan((25 + roughness * std::log10(wall_strength_pa / (normal / 2))) * degree);
}

/// Under a shear force that acts 1 m below the centroid, each end of the base having half of it: concave, as the law
/// is, it bears less than under an even stress.
double base_bears(double slope_deg, double shear) {
  const double normal = weight * std::cos(slope_deg * degree);
  return bears(normal / 2 - shear / 4) + bears(normal / 2 + shear / 4);
}

TEST(RoughJoint, StrengthReductionFindsTheFrictionOfItsStress) {
  for (const double slope_deg : {20.0, 35.0}) {
    const scene::Scene scene = on_a_slope(slope_deg);
    const double shear = weight * std::sin(slope_deg * degree);
    const double factor = base_bears(slope_deg, shear) / shear;
    EXPECT_NEAR(static_strength(scene, nullptr, 0, factor).factor / factor, 1, 1e-6) << slope_deg;
  }
}

TEST(RoughJoint, LimitAnalysisFindsThatOfTheMeanStress) {
  for (const double slope_deg : {20.0, 35.0}) {
    const scene::Scene scene = on_a_slope(slope_deg);
    const limit::Wrenches loads = limit::combined(statics::weights_of(scene), 1, statics::stated_loads_of(scene, 0));
    const limit::LimitStrength found = limit::limit_strength(limit::LimitAnalysis(scene), loads);
    const double factor = base_bears(slope_deg, 0) / (weight * std::sin(slope_deg * degree));
    EXPECT_NEAR(found.factor / factor, 1, 1e-8) << slope_deg;
    EXPECT_LT(found.gap, 1e-8);
  }
}

TEST(RoughJoint, ABlockThatSlidesHasTheFrictionOfItsStressByAllFormulations) {
  constexpr double slope_deg = 62;
  double shear = 0;
  for (int i = 0; i < 50; ++i) shear = base_bears(slope_deg, shear);
  const double a = 9.81 * (std::sin(slope_deg * degree) - shear / weight);
  ASSERT_GT(a, 0.1);
  for (const char* formulation : {"augmented-lagrangian", "lagrange-multiplier", "penalty"}) {
    const scene::Scene scene = on_a_slope(slope_deg, fmt::format("[contact]\nformulation = \"{}\"\n", formulation));
    Solid solid(scene);
    solid.settle({});
    for (int n = 0; n < 50; ++n) solid.advance(0.01 * n, 0.01 * (n + 1), {});
    EXPECT_NEAR(solid.velocity(1)[0] / (0.5 * a), 1, 1e-3) << formulation;
  }
}

TEST(RoughJoint, AFormulaForAFrictionAngleIsRefused) {
  const scene::Scene scene = on_a_slope(20, "[[joints]]\nname = \"base\"\nbetween = [\"ground\", \"block\"]\n");
  EXPECT_THAT([&] { expect::plane_joint(scene, "base"); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("changes with the normal stress")));
}

}  // namespace
}  // namespace blockweir::solid::rough_joint_test
