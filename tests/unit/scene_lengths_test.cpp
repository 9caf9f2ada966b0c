// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Lengths that a scene does not state are fractions of its structure's size, from 3 mm to 3 km.
#include <fmt/format.h>

#include "bridge/scene/structure_size.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_lengths_test {
using namespace blockweir::scene;
using testing::IsEmpty;

namespace {

/// A triangular dam on the ground, `h` m high, and what else the test wants in [water].
std::string dam(double h, const std::string& water = "") {
  return fmt::format(R"([analysis]
duration_s = {}
step_s = {}
[material.m]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[{}, {}], [{}, {}], [{}, 0], [{}, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[0, 0], [{}, 0], [0, {}]]
[[joints]]
name = "base"
between = ["ground", "dam"]
uplift = "triangular"
[water]
upstream_level_m = {}
{}
)",
                     h, h / 100, -2 * h, -h, 3 * h, -h, 3 * h, -2 * h, 0.8 * h, h, 0.5 * h, water);
}

Scene scene_of(const std::string& scene) {
  return read_text(scene, "s.toml").scene;
}

TEST(SceneLengths, ADamOfTwentyMetresHasRoundOnes) {
  const Scene s = scene_of(dam(20));
  EXPECT_EQ(structure_size_m(s.blocks), 20);
  EXPECT_DOUBLE_EQ(s.analysis.failure_displacement_m, 0.02);
  EXPECT_NEAR(s.analysis.rest_speed_m_per_s, 1e-5, 0.03e-5);
  EXPECT_DOUBLE_EQ(s.water.open_crack_width_m, 0.05);
  EXPECT_DOUBLE_EQ(s.contact.penetration_tolerance_m, 1e-9);
}

TEST(SceneLengths, AModelInTheLaboratoryAndAMountainAreAlikeByFroudesLaw) {
  const Scene one = scene_of(dam(1));
  for (const double h : {0.003, 0.03, 0.3, 3.0, 30.0, 300.0, 3000.0}) {
    const Scene s = scene_of(dam(h));
    EXPECT_NEAR(s.analysis.failure_displacement_m / h, one.analysis.failure_displacement_m, 1e-15);
    EXPECT_NEAR(s.analysis.rest_speed_m_per_s / std::sqrt(h), one.analysis.rest_speed_m_per_s, 1e-18);
    EXPECT_NEAR(s.water.open_crack_width_m / h, one.water.open_crack_width_m, 1e-15);
    EXPECT_NEAR(s.contact.penetration_tolerance_m / h, one.contact.penetration_tolerance_m, 1e-22);
    EXPECT_THAT(sample::warnings(dam(h)), IsEmpty()) << h;
  }
}

TEST(SceneLengths, AStatedLengthStands) {
  const Scene s =
      scene_of(sample::with("duration_s = 3",
                            "duration_s = 3\nfailure_displacement_m = 0.7\n"
                            "rest_speed_m_per_s = 2e-5",
                            dam(3, "open_crack_width_m = 0.011\n[contact]\npenetration_tolerance_m = 1e-8")));
  EXPECT_EQ(s.analysis.failure_displacement_m, 0.7);
  EXPECT_EQ(s.analysis.rest_speed_m_per_s, 2e-5);
  EXPECT_EQ(s.water.open_crack_width_m, 0.011);
  EXPECT_EQ(s.contact.penetration_tolerance_m, 1e-8);
}

TEST(SceneLengths, WithoutGravitySpeedsAreThoseOfTheEarth) {
  const std::string weightless = dam(20).substr(0, dam(20).find("[[joints]]"));
  EXPECT_EQ(scene_of(sample::with("step_s", "gravity_m_per_s2 = 0\nstep_s", weightless)).analysis.rest_speed_m_per_s,
            scene_of(weightless).analysis.rest_speed_m_per_s);
}

TEST(SceneLengths, TheSizeIsOfWhatCanMoveOrOfAllWhereNothingCan) {
  Scene s = scene_of(dam(20));
  EXPECT_EQ(structure_size_m(s.blocks), 20);
  for (Block& block : s.blocks) block.fixed = true;
  EXPECT_EQ(structure_size_m(s.blocks), 100);
  EXPECT_EQ(structure_size_m({}), 1);
}

TEST(SceneLengths, AWallOfBricksIsMeasuredByItsBricks) {
  const std::string wall =
      "[analysis]\nduration_s = 1\n[material.m]\nyoungs_modulus_pa = 30e9\npoissons_ratio = 0.2\n"
      "density_kg_per_m3 = 2400\n[[wall]]\nname = \"w\"\nmaterial = \"m\"\nbrick_length_m = 0.4\nbrick_height_m = 0.2\n"
      "rows = 200\ncolumns = 20\nfixed_base = true\n[water]\nupstream_level_m = 9\n";
  const Scene s = scene_of(wall);
  EXPECT_NEAR(typical_width_m(s.blocks), 0.2, 1e-12);
  EXPECT_NEAR(s.analysis.failure_displacement_m, 0.02, 1e-12);  // not 1e-3 of 39.8 m
  EXPECT_NEAR(s.water.open_crack_width_m, 0.05, 1e-12);
}

TEST(SceneLengths, ACrackWidthThatTheWaterCannotTellFromNoneIsAnError) {
  for (const double h : {0.003, 20.0, 3000.0}) {
    sample::expect_error(
        dam(h, fmt::format("open_crack_width_m = {}", 0.9e-7 * h)), 23,
        {"open_crack_width_m is", "in a structure of", "at least 1e-7 of the structure's size", "or leave it out"});
    EXPECT_THAT(sample::errors(dam(h, fmt::format("open_crack_width_m = {}", 1.1e-7 * h))), IsEmpty());
  }
}

TEST(SceneLengths, ACrackWidthAsLargeAsTheStructureIsAWarning) {
  sample::expect_warning(dam(0.03, "open_crack_width_m = 0.05"), 23,
                         {"open_crack_width_m is 0.05 m in a structure of 0.03 m", "expected up to 0.0015 m"});
}

TEST(SceneLengths, OverlapsArePassedOverBelowAMillionthOfTheBlock) {
  for (const double h : {0.003, 0.03, 0.3, 3.0, 30.0, 300.0, 3000.0}) {
    const auto lowered = [&](double by) {
      return sample::with(fmt::format("[[0, 0], [{}, 0]", 0.8 * h),
                          fmt::format("[[0, {}], [{}, {}]", -by, 0.8 * h, -by), dam(h));
    };
    EXPECT_THAT(sample::errors(lowered(0.5e-6 * h)), IsEmpty()) << h;
    EXPECT_THAT(sample::errors(lowered(1e-5 * h)), testing::Contains(testing::HasSubstr("overlap"))) << h;
  }
}

}  // namespace
}  // namespace blockweir::scene_lengths_test
