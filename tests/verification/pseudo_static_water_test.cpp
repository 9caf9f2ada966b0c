// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic fluid_reservoir bridge_scene_read
// Factors of safety in a pseudo-static earthquake, the water's added pressure by finite elements.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::process::pseudo_static_water_test {
namespace {

std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder) {
  return scene.fluid == scene::FluidModel::reservoir ? reservoir::make(scene, folder)
                                                     : hydrostatic::make(scene, folder);
}

/// A broad dam with an upright face on a level base that slides.
nlohmann::json safety_of(double height_m, double width_m, double level_m, double k, const char* more) {
  return safety_answer(scene::read_text(fmt::format(R"(analysis = {{ kind = "static", duration_s = 1, rigid = "all" }}
material.m = {{ youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
joint = {{ friction_angle_deg = 40 }}
water = {{ upstream_level_m = {} }}
earthquake.horizontal_coefficient = {}
{}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-300, -10], [300, -10], [300, 0], [-300, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
)",
                                                    level_m, k, more, width_m, width_m, height_m, height_m),
                                        "earthquake")
                           .scene,
                       make);
}

TEST(PseudoStaticWater, TheFactorOnStrengthHasTheForceOfLinearWater) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 10; ++i) {
    const double height = 10 + 60 * any(random);
    const double width = (1 + any(random)) * height;
    const double level = (0.5 + 0.5 * any(random)) * height;
    const double k = 0.05 + 0.15 * any(random);
    const double weight = 2400 * 9.81 * height * width;
    const double still = 9810 * level * level / 2;
    const double strength = weight * std::tan(40 * std::acos(-1.0) / 180);
    const auto answer = safety_of(height, width, level, k, "fluid = { model = \"reservoir\" }");
    EXPECT_EQ(answer["added_water_pressure"], "finite elements");
    const double factor = strength / (still + k * weight + k * 9810 * 0.5427545 * level * level);
    EXPECT_NEAR(answer["limit_analysis_factor"].get<double>() / factor, 1, 2e-5) << i;
    EXPECT_NEAR(answer["factor"].get<double>() / factor, 1, 2e-5) << i;
    const auto formula = safety_of(height, width, level, k, "");
    EXPECT_EQ(formula["added_water_pressure"], "Westergaard");
    const double by_formula = strength / (still + k * weight + k * 9810 * 7 / 12 * level * level);
    EXPECT_NEAR(formula["limit_analysis_factor"].get<double>() / by_formula, 1, 1e-6) << i;
  }
}

/// Water on ground that goes up weighs as much more as the dam does, whether the ground also goes to one side or not.
TEST(PseudoStaticWater, AVerticalEarthquakeAlonePressesByWaterToo) {
  for (const double k_v : {-0.3, -0.1, 0.2}) {
    const auto vertical = fmt::format("fluid = {{ model = \"reservoir\" }}\nearthquake.vertical_coefficient = {}", k_v);
    const auto answer = safety_of(12, 20, 11, 0, vertical.c_str());
    EXPECT_EQ(answer["added_water_pressure"], "finite elements");
    const double factor = 2400 * 12 * 20 * std::tan(40 * std::acos(-1.0) / 180) / (1000.0 * 11 * 11 / 2);
    EXPECT_NEAR(answer["limit_analysis_factor"].get<double>() / factor, 1, 1e-4) << k_v;
    EXPECT_NEAR(answer["factor"].get<double>() / factor, 1, 1e-4) << k_v;
  }
}

TEST(PseudoStaticWater, StillWaterHasNoFiniteElementsOfIt) {
  EXPECT_THROW(
      scene::read_text("earthquake = { horizontal_coefficient = 0.1, added_water_pressure = \"reservoir\" }", "x"),
      std::exception);
}

}  // namespace
}  // namespace blockweir::process::pseudo_static_water_test
