// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit bridge_scene_read
// Limit analysis against hand values and published figures.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "bridge/scene/read/read.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/limit/limit_level.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/limit/mechanism_description.hpp"
#include "tests/samples.hpp"

namespace blockweir::limit_analysis_test {
namespace {

using namespace blockweir::solid::limit;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

scene::Scene read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return scene::read_text(text, "test.toml", overrides).scene;
}

/// A block b x h on level ground that is pushed by g in x.
std::string pushed_block(double breadth, double height, double friction_deg, const std::string& law = "") {
  return fmt::format(R"(
[analysis]
duration_s = 1
[material.stone]
youngs_modulus_pa = 1e10
poissons_ratio = 0.2
density_kg_per_m3 = 2000
[joint]
friction_angle_deg = {2}
{3}
[[block]]
name = "ground"
material = "stone"
fixed = true
vertices_m = [[-5, -1], [15, -1], [15, 0], [-5, 0]]
[[block]]
name = "block"
material = "stone"
vertices_m = [[0, 0], [{0}, 0], [{0}, {1}], [0, {1}]]
[[body_load]]
blocks = ["block"]
acceleration_x_m_per_s2 = 9.81
)",
                     breadth, height, friction_deg, law);
}

LargestFactor push(const scene::Scene& scene) {
  return LimitAnalysis(scene).largest_factor(statics::weights_of(scene),
                                             statics::stated_loads_of(scene, scene.analysis.duration_s));
}

TEST(LimitAnalysis, ABlockSlidesOrTurnsWhicheverComesFirst) {
  for (const auto& [breadth, height, friction_deg] :
       {std::tuple{2.0, 1.0, 30.0}, {1.0, 2.0, 40.0}, {0.3, 7.0, 10.0}, {1.0, 1.0, 44.9}, {1.0, 1.0, 45.1}}) {
    const scene::Scene scene = read(pushed_block(breadth, height, friction_deg));
    const LargestFactor found = push(scene);
    const double mu = std::tan(radians(friction_deg));
    EXPECT_NEAR(found.factor, std::min(mu, breadth / height), 1e-12);
    EXPECT_LT(found.gap, 1e-10);
    const MechanismDescription words = words_of(LimitAnalysis(scene), found.mechanism);
    EXPECT_EQ(words.mode, mu < breadth / height ? "sliding" : "overturning") << words.text;
    EXPECT_EQ(words.dilates, mu < breadth / height) << "what slides rises by the associated rule";
  }
}

/// T L/2 at the heel holds a block of width b by T b^2/2.
TEST(LimitAnalysis, CohesionAndTensionStrengthHoldByTheirOwnArms) {
  const double weight = 2000 * 9.81 * 2 * 1;
  const LargestFactor slides = push(read(pushed_block(2, 1, 20, "cohesion_pa = 5e3")));
  EXPECT_NEAR(slides.factor, std::tan(radians(20)) + 5e3 * 2 / weight, 1e-12);
  const LargestFactor turns = push(read(pushed_block(1, 2, 60, "cohesion_pa = 20e3\ntension_strength_pa = 6e3")));
  EXPECT_NEAR(turns.factor, (weight * 0.5 + 6e3 / 2 * 1) / (weight * 1), 1e-12);
  EXPECT_LT(turns.gap, 1e-10);
}

TEST(LimitAnalysis, WhatNothingCanMoveBearsAnyFactor) {
  const scene::Scene scene = read(pushed_block(1, 1, 30));
  const LimitAnalysis structure(scene);
  const Wrenches down(scene.blocks.size(), Wrench(0, -1, 0));
  EXPECT_EQ(structure.largest_factor(statics::weights_of(scene), down).bearing, Bearing::bears_any);
  const Wrenches up(scene.blocks.size(), Wrench(0, 1e9, 0));
  EXPECT_FALSE(structure.bears(up));
}

/// Ferris and Tin-Loi 2001, walls 1 to 3: 0.64286, 0.58000, 0.40369 with associated flow.
TEST(LimitAnalysis, MasonryWallsOfFerrisAndTinLoi) {
  const std::string text_of_case = std::string(BLOCKWEIR_SOURCE) + "/cases/masonry-walls";
  for (const auto& [load, expected] : {std::pair{0, 0.64286}, {1, 0.58000}, {2, 0.40369}}) {
    scene::Scene scene = scene::read(text_of_case).scene;
    for (std::size_t i = 0; i < scene.body_loads.size(); ++i) {
      const bool pushed = static_cast<int>(i) == load;
      scene.body_loads[i].value[0] = scene::TimeTable::constant(pushed ? scene.analysis.gravity_m_per_s2 : 0);
    }
    const LargestFactor found = push(scene);
    EXPECT_NEAR(found.factor, expected, 1e-5);
    EXPECT_LT(found.gap, 1e-8);
  }
}

TEST(LimitAnalysis, StrengthOfAnInclineIsTheSlopesAndBelowOneWhereItSlides) {
  for (const auto& [slope_deg, friction_deg] : {std::pair{20.0, 30.0}, {30.0, 20.0}, {10.0, 60.0}}) {
    const scene::Scene scene = read(pushed_block(4, 0.5, friction_deg, ""),
                                    {fmt::format("analysis.gravity_tilt_deg={}", slope_deg), "body_load=[]"});
    const LimitStrength found = limit_strength(LimitAnalysis(scene), statics::weights_of(scene));
    EXPECT_EQ(found.bearing, Bearing::fails_at_a_factor);
    EXPECT_NEAR(found.factor / (std::tan(radians(friction_deg)) / std::tan(radians(slope_deg))), 1, 1e-8);
    EXPECT_LT(found.gap, 1e-8);
  }
}

TEST(LimitAnalysis, NoStrengthHelpsWhatOverturnsAndNoneIsNeededOnLevelGround) {
  const scene::Scene turns = read(pushed_block(0.5, 4, 30), {"analysis.gravity_tilt_deg=20", "body_load=[]"});
  EXPECT_EQ(limit_strength(LimitAnalysis(turns), statics::weights_of(turns)).bearing, Bearing::bears_none);
  const scene::Scene level = read(pushed_block(1, 1, 30), {"body_load=[]"});
  EXPECT_EQ(limit_strength(LimitAnalysis(level), statics::weights_of(level)).bearing, Bearing::bears_any);
}

/// Water on the left of a block b x h: slides at sqrt(2 W mu/(rho g)), turns at cbrt(3 W b/(rho g)).
TEST(LimitAnalysis, TheLevelOfAWallUnderWater) {
  for (const auto& [width, friction_deg] : {std::pair{6.0, 15.0}, {2.0, 60.0}}) {
    const double breadth = width;
    const scene::Scene scene = read(pushed_block(breadth, 10, friction_deg), {"body_load=[]"});
    const double water = 9810;
    const auto at_level = [&](double level_m) {
      const double head = std::max(0.0, level_m);
      Wrenches forces(scene.blocks.size(), Wrench::Zero());
      forces[1] = wrench_of({water * head * head / 2, 0}, {0, head / 3}, {breadth / 2, 5});
      return forces;
    };
    const LimitLevel found = limit_level(LimitAnalysis(scene), statics::weights_of(scene), at_level, {-1, 10});
    const double weight = 2000 * 9.81 * breadth * 10;
    const double slides = std::sqrt(2 * weight * std::tan(radians(friction_deg)) / water);
    const double turns = std::cbrt(3 * weight * breadth / water);
    ASSERT_EQ(found.outcome, Filled::fails);
    EXPECT_NEAR(found.level_m, std::min(slides, turns), 1e-11);
    EXPECT_LE(found.programs, 3);
    EXPECT_LT(found.at_it.gap, 1e-8);
  }
}

TEST(LimitAnalysis, AStructureThatDoesNotStandEmptyOrFailsAtNoLevelIsAnAnswer) {
  const scene::Scene slides = read(pushed_block(4, 1, 10), {"analysis.gravity_tilt_deg=20", "body_load=[]"});
  const auto none = [&](double) { return Wrenches(slides.blocks.size(), Wrench::Zero()); };
  EXPECT_EQ(limit_level(LimitAnalysis(slides), statics::weights_of(slides), none, {0, 1}).outcome,
            Filled::does_not_stand_empty);
  const scene::Scene stands = read(pushed_block(4, 1, 30), {"body_load=[]"});
  EXPECT_EQ(limit_level(LimitAnalysis(stands), statics::weights_of(stands), none, {0, 1}).outcome, Filled::stands_full);
}

/// An anchor that leads down and downstream, and so shortens as the block slides: it keeps what a failure's
/// displacement leaves of its prestress, none below zero, and less where it is a strut.
TEST(LimitAnalysis, AnAnchorHoldsAtLeastWhatAFailuresDisplacementLeavesOfItsPrestress) {
  const auto factor = [](double stiffness, const std::string& more) {
    const scene::Scene scene =
        read(pushed_block(4, 1, 30) +
                 fmt::format("[[bolt]]\nname = 'a'\nfrom_block = 'block'\nfrom_m = [1, 0.2]\nto_m = [1.4, -0.1]\n"
                             "stiffness_n_per_m2 = {}\nprestress_n_per_m = 50e3\nyield_n_per_m = 50e3\n{}",
                             stiffness, more),
             {"analysis.failure_displacement_m=0.01", "body_load.0.acceleration_x_m_per_s2=2"});
    return limit_strength(LimitAnalysis(scene),
                          combined(statics::weights_of(scene), 1, statics::stated_loads_of(scene, 1)))
        .factor;
  };
  const double weight = 2000 * 9.81 * 4;
  const auto by_hand = [&](double pull) {
    return (weight + 0.6 * pull) * std::tan(radians(30)) / (2000 * 2 * 4 + 0.8 * pull);
  };
  EXPECT_NEAR(factor(1e-6, "") / by_hand(50e3), 1, 1e-9);
  EXPECT_NEAR(factor(2e6, "") / by_hand(30e3), 1, 1e-9);
  EXPECT_NEAR(factor(1e9, "") / by_hand(0), 1, 1e-9);
  EXPECT_NEAR(factor(6e6, "takes_compression = true") / by_hand(-10e3), 1, 1e-9);
}

TEST(LimitAnalysis, IsExactWhereForcesFollowFromEquilibriumAlone) {
  const scene::Scene one = read(pushed_block(4, 1, 30));
  EXPECT_TRUE(LimitAnalysis(one).is_exact());
  const auto on_top = [](const std::string& name, double from, double to) {
    return fmt::format(
        "[[block]]\nname = '{0}'\nmaterial = 'stone'\nvertices_m = [[{1}, 1], [{2}, 1], [{2}, 2], [{1}, 2]]\n", name,
        from, to);
  };
  const scene::Scene stack = read(pushed_block(4, 1, 30) + on_top("top", 1, 3));
  EXPECT_TRUE(LimitAnalysis(stack).is_exact());
  const scene::Scene beside = read(pushed_block(4, 1, 30) + on_top("left", 0, 2) + on_top("right", 2, 4));
  EXPECT_FALSE(LimitAnalysis(beside).is_exact());
  const scene::Scene apart = read(pushed_block(4, 1, 30) + on_top("left", 0, 1) + on_top("right", 2, 4));
  EXPECT_TRUE(LimitAnalysis(apart).is_exact());
  const scene::Scene bonded = read(pushed_block(4, 1, 30, "cohesion_pa = 1e3"));
  EXPECT_FALSE(LimitAnalysis(bonded).is_exact());
  const std::string bolt =
      "[[bolt]]\nname = 'a'\nfrom_block = 'block'\nfrom_m = [1, 0.5]\nto_m = [1, -0.5]\nstiffness_n_per_m2 = 1e6\n";
  const scene::Scene tied = read(pushed_block(4, 1, 30) + bolt);
  EXPECT_FALSE(LimitAnalysis(tied).is_exact());
  EXPECT_TRUE(LimitAnalysis(tied).holds_any_force());
  const scene::Scene yields = read(pushed_block(4, 1, 30) + bolt + "yield_n_per_m = 1e5\n");
  EXPECT_FALSE(LimitAnalysis(yields).holds_any_force());
}

/// Rows of bricks without mortar, under a push to the right of g.
std::string wall_of_bricks(std::mt19937& random) {
  const auto between = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  const int rows = 2 + static_cast<int>(random() % 5);
  const int columns = 2 + static_cast<int>(random() % 3);
  const double height = std::pow(10, between(-1, 2));
  const double brick_height = height / rows;
  const double brick = brick_height * between(1.2, 3.5);
  const double length = brick * columns;
  std::string text = fmt::format(
      "analysis = {{duration_s = 1, rigid = 'all'}}\njoint = {{friction_angle_deg = {0}}}\n"
      "material.m = {{youngs_modulus_pa = 2e10, poissons_ratio = 0.2, density_kg_per_m3 = 2400}}\n"
      "body_load = [{{acceleration_x_m_per_s2 = 9.81}}]\n[[block]]\nname = 'rock'\nmaterial = 'm'\nfixed = true\n"
      "vertices_m = [[{1}, {2}], [{3}, {2}], [{3}, 0], [{1}, 0]]\n",
      between(20, 50), -3 * length, -height, 4 * length);
  int name = 0;
  for (int row = 0; row < rows; ++row) {
    const double offset = std::array{0.0, 0.5, between(0.2, 0.8)}[random() % 3];
    std::vector<double> ends = {0};
    for (int column = 0; column <= columns; ++column) {
      const double x = (column + offset) * brick;
      if (x > 0.15 * brick && x < length - 0.15 * brick) ends.push_back(x);
    }
    ends.push_back(length);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      text += fmt::format(
          "[[block]]\nname = 'b{0}'\nmaterial = 'm'\nvertices_m = [[{1}, {3}], [{2}, {3}], [{2}, {4}], "
          "[{1}, {4}]]\n",
          name++, ends[i - 1], ends[i], row * brick_height, (row + 1) * brick_height);
    }
  }
  return text;
}

/// What a wall bears at its limit it bears with no strength to spare, and nine tenths of it with some. Arms that are
/// zero but for rounding once made its programs singular, or let them find no forces.
TEST(LimitAnalysis, WallsOfBricksAllHaveTheirFactors) {
  for (int seed = 0; seed < test::samples(40); ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    const scene::Scene scene = read(wall_of_bricks(random));
    const LimitAnalysis structure(scene);
    const Wrenches weights = statics::weights_of(scene);
    const Wrenches stated = statics::stated_loads_of(scene, 1);
    ASSERT_TRUE(structure.bears(weights)) << seed;
    const LargestFactor loads = structure.largest_factor(weights, stated);
    ASSERT_EQ(loads.bearing, Bearing::fails_at_a_factor) << seed;
    EXPECT_LE(loads.factor, std::tan(radians(scene.default_joint.friction_angle_deg)) * (1 + 1e-9)) << seed;
    EXPECT_LE(loads.gap, 1e-8) << seed;
    EXPECT_FALSE(structure.bears(combined(weights, loads.factor * (1 + 1e-6), stated))) << seed;
    const LimitStrength strength = limit_strength(structure, combined(weights, 0.9 * loads.factor, stated));
    ASSERT_EQ(strength.bearing, Bearing::fails_at_a_factor) << seed;
    EXPECT_GT(strength.factor, 1) << seed;
    EXPECT_LE(strength.gap, 1e-8) << seed;
  }
}

}  // namespace
}  // namespace blockweir::limit_analysis_test
