// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic fluid_reservoir bridge_scene_read
// Natural frequencies, dry and wet, against closed forms and published figures.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::process::natural_modes_test {
namespace {

using nlohmann::json;

json modes_of(const std::string& text) {
  return modes_answer(scene::read_text(text, "modes").scene, hydrostatic::make, reservoir::mass_on_faces);
}

double omega(const json& modes, std::size_t k) {
  return modes[k]["omega_rad_per_s"].get<double>();
}

std::string koyna(double level_m) {
  return fmt::format(R"(analysis = {{ kind = "static", duration_s = 1, plane = "stress" }}
material.m = {{ youngs_modulus_pa = 31.027e9, poissons_ratio = 0.2, density_kg_per_m3 = 2643 }}
joint = {{ friction_angle_deg = 45, cohesion_pa = 1e9, tension_strength_pa = 1e9 }}
{}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-50, -20], [120, -20], [120, 0], [-50, 0]]
[[block]]
name = "dam"
material = "m"
mesh_size_m = 4
vertices_m = [[0, 0], [70, 0], [19.25, 66.5], [14.8, 103], [0, 103]]
)",
                     level_m > 0 ? fmt::format("water = {{ upstream_level_m = {} }}", level_m) : "");
}

TEST(NaturalModes, KoynaDamHasItsFrequenciesWithoutWaterAndWithIt) {
  const json answer = modes_of(koyna(91.75));
  const std::array<double, 4> computed{18.91, 50.22, 68.19, 98.95};  // by finite elements
  for (std::size_t k = 0; k < computed.size(); ++k)
    EXPECT_NEAR(omega(answer["dry"], k), computed[k], 0.01 * computed[k]);
  EXPECT_NEAR(omega(answer["wet"], 0), 17.38, 0.01 * 17.38);
  const json dry = modes_of(koyna(0));
  EXPECT_FALSE(dry.contains("wet"));
  EXPECT_NEAR(omega(dry["dry"], 0), omega(answer["dry"], 0), 1e-3);
}

/// A wall on smooth ground, held by an anchor along the ground.
std::string wall_on_a_spring(double height_m, double width_m, double depth_m, double spring_n_per_m2, double friction) {
  return fmt::format(R"(analysis = {{ kind = "static", duration_s = 1, rigid = "all", failure_displacement_m = 10 }}
material.m = {{ youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
joint = {{ friction_angle_deg = {} }}
water = {{ upstream_level_m = {} }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-300, -5], [300, -5], [300, 0], [-300, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
[[bolt]]
name = "anchor"
from_block = "rock"
to_block = "wall"
from_m = [-100, 0]
to_m = [0, 0]
stiffness_n_per_m2 = {}
)",
                     friction, depth_m, width_m, width_m, height_m, height_m, spring_n_per_m2);
}

TEST(NaturalModes, AWallOnASpringSwingsMoreSlowlyByTheWatersMass) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  for (int i = 0; i < 12; ++i) {
    const double height = 5 + 40 * any(random);
    const double width = (0.6 + 0.6 * any(random)) * height;
    const double depth = (0.5 + 0.5 * any(random)) * height;
    const double spring = 1e8 * std::pow(30, any(random));
    const json answer = modes_of(wall_on_a_spring(height, width, depth, spring, 0));
    const double mass = 2400 * height * width;
    const double water = 0.5427545 * 1000 * depth * depth;
    EXPECT_NEAR(omega(answer["dry"], 0) / std::sqrt(spring / mass), 1, 1e-5) << i;
    EXPECT_NEAR(omega(answer["wet"], 0) / omega(answer["dry"], 0), std::sqrt(mass / (mass + water)), 1e-4) << i;
    EXPECT_NEAR(answer["dry"][0]["mass_share_x"].get<double>(), 1, 1e-6);
  }
}

/// A soft spring beside stiff stone is lost neither in the contacts' stiffness nor among what is free.
TEST(NaturalModes, TheModulusOfRigidBlocksHasNoEffect) {
  std::string text = wall_on_a_spring(2, 1.6, 1.5, 2e5, 0);  // of rigid blocks
  const std::size_t modulus = text.find("youngs_modulus_pa = ") + 20;
  for (const char* value : {"1e8", "1e10", "1e12", "1e14"}) {
    text.replace(modulus, text.find(',', modulus) - modulus, value);
    const json answer = modes_of(text);
    EXPECT_NEAR(omega(answer["dry"], 0) / std::sqrt(2e5 / (2400 * 2 * 1.6)), 1, 1e-5) << value;
    EXPECT_NEAR(omega(answer["wet"], 0) / omega(answer["dry"], 0),
                std::sqrt(1 / (1 + 0.5427545 * 1000 * 1.5 * 1.5 / (2400 * 2 * 1.6))), 1e-4)
        << value;
  }
}

TEST(NaturalModes, WhatNothingHoldsIsFreeAndSaid) {
  std::string text = wall_on_a_spring(10, 8, 5, 1e8, 0);
  text.erase(text.find("[[bolt]]"));
  text.erase(text.find("water ="), text.find("[[block]]") - text.find("water ="));
  const json answer = modes_of(text);
  EXPECT_EQ(omega(answer["dry"], 0), 0);
  EXPECT_TRUE(answer["dry"][0]["period_s"].is_null());
  EXPECT_THAT(answer["warnings"].dump(), testing::HasSubstr("1 motions have no frequency"));
}

/// No ground below: its base stretches its anchors by rounding and more, and stays dry.
TEST(NaturalModes, AWallOnAnchorsAloneHasNoWaterUnderIt) {
  const auto wall = [](const char* ground, double stiffness) {
    return modes_of(fmt::format(R"(analysis = {{ duration_s = 1, rigid = "all" }}
material.c = {{ youngs_modulus_pa = 3e10, poissons_ratio = 0.2, density_kg_per_m3 = 2700 }}
water = {{ upstream_level_m = 3 }}
bolt = [
  {{ name = "a", from_block = "w", from_m = [0, 0], to_m = [0, -10], stiffness_n_per_m2 = {0}, takes_compression = true }},
  {{ name = "b", from_block = "w", from_m = [1.5, 0], to_m = [1.5, -10], stiffness_n_per_m2 = {0}, takes_compression = true }},
  {{ name = "c", from_block = "w", from_m = [1.5, 0.8], to_m = [18, 0.8], stiffness_n_per_m2 = {0}, takes_compression = true }}]
[[block]]
name = "w"
material = "c"
vertices_m = [[0, 0], [1.5, 0], [1.5, 4], [0, 4]]
{1})",
                                stiffness, ground));
  };
  for (const double stiffness : {1e9, 1e10}) {
    const json alone = wall("", stiffness);
    const json beside = wall(
        "[[block]]\nname = \"g\"\nmaterial = \"c\"\nfixed = true\nvertices_m = [[-40, -9], [30, -9], [30, -0.001], "
        "[-40, -0.001]]",
        stiffness);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(omega(alone["wet"], k), omega(beside["wet"], k), 2e-3 * omega(beside["wet"], k)) << k;
    }
  }
}

TEST(NaturalModes, ContactsAreNoSpringsAndEvenStrainIsWarnedOf) {
  std::string text = wall_on_a_spring(10, 8, 5, 1e8, 30);
  text.erase(text.find("[[bolt]]"));
  EXPECT_THAT([&] { modes_of(text); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("nothing swings: found rigid blocks")));
  text.replace(text.find("rigid = \"all\""), 13, "rigid = \"none\"");
  const json answer = modes_of(text);
  EXPECT_THAT(answer["warnings"].dump(), testing::HasSubstr("has no mesh and strains evenly"));
  EXPECT_LT(omega(answer["dry"], answer["dry"].size() - 1), 1e5);
}

TEST(NaturalModes, WhatDoesNotStandHasNone) {
  const std::string text = wall_on_a_spring(20, 2, 20, 1e8, 0);
  EXPECT_THAT([&] { modes_of(text); },
              testing::ThrowsMessage<std::runtime_error>(
                  testing::AllOf(testing::HasSubstr("does not come to rest under its loads, at a level of "),
                                 testing::HasSubstr("set a lower one, as by --set water.upstream_level_m=..."))));
}

}  // namespace
}  // namespace blockweir::process::natural_modes_test
