// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Blocks let go as they are drawn decide where static steps creep: they are to come to rest where statics say so.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/capacity/released_blocks.hpp"
#include "solid/capacity/static_strength.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/jointed_abutment.hpp"

namespace blockweir::solid::released_blocks_test {
namespace {

constexpr double to_rad = std::numbers::pi / 180;

bool come_to_rest(const scene::Scene& scene) {
  SearchBudget effort("test");
  return ReleasedBlocks(scene, nullptr, effort).come_to_rest(std::nan(""));
}

std::string outcome_of(const scene::Scene& scene) {
  try {
    return come_to_rest(scene) ? "rests" : "fails";
  } catch (const Undecided& why) {
    return why.what();
  }
}

/// A block on ground that dips, which gravity does instead.
scene::Scene on_plane(double dip_deg, double width_m, double height_m, double friction_deg, const char* more = "") {
  return scene::read_text(fmt::format(R"(analysis = {{ duration_s = 1, gravity_tilt_deg = {}{} }}
joint = {{ friction_angle_deg = {} }}
material.m = {{ youngs_modulus_pa = 20e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-50, -5], [50, -5], [50, 0], [-50, 0]]
[[block]]
name = "block"
material = "m"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
)",
                                      dip_deg, more, friction_deg, width_m, width_m, height_m, height_m),
                          "plane")
      .scene;
}

TEST(ReleasedBlocks, RestOnAPlaneUpToTheirFriction) {
  for (int seed = 1; seed <= test::campaign(3); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const double dip_deg = random.between(8, 40);
    const scene::Scene scene = on_plane(dip_deg, random.between(4, 8), 2, dip_deg);
    EXPECT_TRUE(come_to_rest(with_reduced_strength(scene, 0.99))) << seed;
    EXPECT_FALSE(come_to_rest(with_reduced_strength(scene, 1.01))) << seed;
  }
}

TEST(ReleasedBlocks, TurnOverWhereTheirWeightLeavesTheBase) {
  for (int seed = 1; seed <= test::campaign(3); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const double height_m = random.between(4, 8);
    const double dip_deg = random.between(10, 25);
    const double width_m = height_m * std::tan(dip_deg * to_rad);
    EXPECT_TRUE(come_to_rest(on_plane(dip_deg, 1.03 * width_m, height_m, 60))) << seed;
    EXPECT_FALSE(come_to_rest(on_plane(dip_deg, 0.97 * width_m, height_m, 60))) << seed;
  }
}

TEST(ReleasedBlocks, SayWhereTheyAreLetGoInVain) {
  EXPECT_EQ(outcome_of(on_plane(5, 4, 2, 0, ", failure_displacement_m = 1e4")),
            "let go as drawn, the blocks neither come to rest nor fail");
  scene::Scene shaken = on_plane(5, 4, 2, 30);
  shaken.base_motion.emplace();
  EXPECT_EQ(outcome_of(shaken), "blocks are not let go in an earthquake");
}

/// Two sets of joints with friction of 50 and more: static steps creep with any strength.
scene::Scene wedged_slope(double modulus_pa) {
  return test::jointed_abutment({-40, 7, 50}, {60, 12, 55}, modulus_pa);
}

TEST(ReleasedBlocks, GiveASlopeWhoseBlocksWedgeEachOtherItsFactor) {
  scene::Scene scene = wedged_slope(20e9);
  const bool stands = come_to_rest(with_reduced_strength(scene, 1.2));
  EXPECT_TRUE(stands);
  EXPECT_FALSE(come_to_rest(with_reduced_strength(scene, 1.35))) << "limit analysis: at most 1.3124";
}

TEST(ReleasedBlocks, AreNamedWhereTheyGiveTheFactor) {
  scene::Scene scene = wedged_slope(20e9);
  scene.contact.max_iterations = 2;  // statics does not begin
  const auto answer = process::safety_answer(scene, hydrostatic::make);
  EXPECT_LT(answer["factor"].get<double>(), answer["limit_analysis_factor"].get<double>());
  EXPECT_THAT(answer["friction_history"].get<std::string>(),
              testing::HasSubstr("let go as drawn, under all loads at once, the blocks come to rest with strength"));
}

TEST(ReleasedBlocks, LeaveTheAnswerToLimitAnalysisWhereTheyHaveNone) {
  scene::Scene scene = wedged_slope(100);  // too soft for its weight: statics does not begin
  scene.base_motion.emplace();
  std::string why;
  try {
    static_strength(scene, nullptr, std::nan(""), 1, 0.99);
  } catch (const TookTooLong& stopped) {
    why = stopped.what();
  }
  EXPECT_EQ(why, "blocks are not let go in an earthquake; limit analysis: at most 1");
}

}  // namespace
}  // namespace blockweir::solid::released_blocks_test
