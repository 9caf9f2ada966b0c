// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Where `safety` has no factor it says why, and what it says is true.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/answers/contradiction.hpp"

namespace blockweir::test::safety_without_answer_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json safety_of(const std::string& modulus_pa, const std::string& more,
               const std::string& joint = "friction_angle_deg = 40") {
  const std::string text = fmt::format(R"(analysis = {{ duration_s = 1 }}
joint = {{ {} }}
material.m = {{ youngs_modulus_pa = {}, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-20, -8], [30, -8], [30, 0], [-20, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [1, 0], [1, 6], [0, 6]]
{})",
                                       joint, modulus_pa, more);
  return process::safety_answer(scene::read_text(text, "wall.toml").scene, hydrostatic::make);
}

TEST(SafetyWithoutAnswer, AStrengthThatSpoilsTheLinearProgramIsSaidInWords) {
  const json answer =
      safety_of("50e9", "[[body_load]]\nacceleration_x_m_per_s2 = 1", "friction_angle_deg = 40, cohesion_pa = 1e15");
  EXPECT_THAT(answer["why_no_limit_analysis_factor"].get<std::string>(),
              HasSubstr("found forces that do not balance within round-off, since loads and strengths are too many "
                        "decades apart"));
}

TEST(SafetyWithoutAnswer, BlocksThatCannotBeSolvedAreNotSaidToFail) {
  const json answer = safety_of("25", "[[body_load]]\nacceleration_x_m_per_s2 = 1");
  EXPECT_EQ(answer["outcome"], "not found");
  EXPECT_THAT(answer["why_no_factor"].get<std::string>(), HasSubstr("not solved with any strength: "));
  EXPECT_NEAR(answer["limit_analysis_factor"].get<double>(), 0.8391 * 9.81, 1e-3);
}

TEST(SafetyWithoutAnswer, WhatOverturnsWhateverItsStrengthHasItsMechanism) {
  const json answer = safety_of("50e9", "[[body_load]]\nacceleration_x_m_per_s2 = 3");
  EXPECT_EQ(answer["outcome"], "fails");
  EXPECT_THAT(answer["why_no_factor"].get<std::string>(), HasSubstr("no shear strength"));
  EXPECT_THAT(answer["mechanism"]["text"].get<std::string>(), HasSubstr("\"wall\" turns over on joint"));
}

/// A wall a tenth of a millimetre above the rock lands on it, and has lost its uplift by then.
TEST(SafetyWithoutAnswer, BlocksThatStandOnlyAfterTheyHaveMovedHaveNoFactor) {
  const auto answer = [](double gap_m) {
    const std::string text = fmt::format(R"(analysis = {{ duration_s = 1 }}
water = {{ upstream_level_m = 3 }}
joint = {{ friction_angle_deg = 30, uplift = "triangular" }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -3], [12, -3], [12, 0], [-10, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, {0}], [2.5, {0}], [1, 5], [0, 5]]
)",
                                         gap_m);
    return process::safety_answer(scene::read_text(text, "wall.toml").scene, hydrostatic::make);
  };
  const json touching = answer(0);
  EXPECT_EQ(touching["outcome"], "stands");
  EXPECT_FALSE(touching.contains("contradiction"));
  const json apart = answer(1e-4);
  EXPECT_EQ(apart["outcome"], "not found");
  EXPECT_TRUE(apart["factor"].is_null());
  EXPECT_TRUE(apart["joints"].empty());
  EXPECT_THAT(apart["why_no_factor"].get<std::string>(),
              testing::AllOf(HasSubstr("the blocks stand only after they have moved (factor "),
                             HasSubstr("faces do not touch, and no uplift acts between them")));
}

TEST(SafetyWithoutAnswer, ASearchWithoutRestBesideALimitFactorSaysWhichOfThemFailed) {
  using solid::limit::Bearing;
  const solid::StaticStrength no_rest{.bearing = Bearing::bears_none, .moving = "s14"};
  for (const auto& [bound, outcome] : {std::pair(0.43, "fails"), std::pair(1.43, "not found")}) {
    json answer = {{"outcome", "fails"}};
    solid::add_contradiction(no_rest, {.bearing = Bearing::fails_at_a_factor, .factor = bound}, answer);
    EXPECT_EQ(answer["outcome"], outcome) << bound;
    EXPECT_THAT(answer["why_no_factor"].get<std::string>(),
                HasSubstr("the blocks find no rest even with 1e6 times the strength; block \"s14\" moves most"));
  }
  json answer = {{"outcome", "fails"}};
  solid::add_contradiction(no_rest, {.bearing = Bearing::bears_none}, answer);
  EXPECT_FALSE(answer.contains("contradiction")) << "both say so";
}

TEST(SafetyWithoutAnswer, WavesThatAreLeftOutAreWarnedOf) {
  const std::string water = "[water]\nupstream_level_m = 2\n[fluid]\nmodel = \"openfoam\"\nupstream_depths = 10\n";
  const json still = safety_of("50e9", water);
  EXPECT_THAT(still["warnings"].dump(), testing::Not(HasSubstr("wave")));
  const json solitary = safety_of("50e9", water + "[fluid.wave]\nkind = \"solitary\"\nheight_m = 0.3\n");
  EXPECT_THAT(solitary["warnings"].dump(), HasSubstr("[fluid.wave] is left out of this static answer: the solitary "
                                                     "wave of 0.3 m in height is not in the water"));
}

TEST(SafetyWithoutAnswer, LoadsBeyondAllSenseAreAReasonAndNoCrash) {
  for (const char* size : {"1e15", "1e300"}) {
    std::string why;
    try {
      why = safety_of("50e9", std::string("[[body_load]]\nacceleration_x_m_per_s2 = ") + size).dump();
    } catch (const std::runtime_error& error) {
      why = error.what();  // the blocks have no answer, either
    }
    EXPECT_THAT(why, HasSubstr("times the structure's weight"));
  }
}

/// Five blocks on stepped rock; outlines in their order.
scene::Scene dam_of_blocks(const std::string& head, const std::array<const char*, 6>& outlines) {
  std::string text =
      "title = \"a dam of blocks on stepped rock\"\n" + head +
      "material.concrete = { youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }\n";
  const std::array<const char*, 6> names = {"rock", "heel", "toe", "middle", "crest", "back"};
  for (std::size_t b = 0; b < names.size(); ++b) {
    text += fmt::format("[[block]]\nname = \"{}\"\nmaterial = \"concrete\"\nfixed = {}\nvertices_m = [{}]\n", names[b],
                        b == 0, outlines[b]);
  }
  return scene::read_text(text, "blocks.toml").scene;
}

/// Where friction is just large enough for blocks to wedge each other, no linear program has an optimum: the forces
/// grow without limit. Limit analysis had no factor of this dam.
TEST(SafetyWithoutAnswer, BlocksThatJamHaveAFactorByLimitAnalysis) {
  const scene::Scene scene = dam_of_blocks(
      R"(analysis = { duration_s = 1, rigid = "all", kind = "static" }
water = { upstream_level_m = 14.69, downstream_level_m = 3.99 }
joint = { friction_angle_deg = 45, uplift = "full" }
)",
      {"[-30, -10], [50, -10], [50, 0], [17.25, 0], [7.24, 0], [7.24, -2.84], "
       "[0, -2.84], [-30, -2.84]",
       "[0, -2.84], [7.24, -2.84], [7.24, 0], [7.24, 6.24], [0, 6.24]",
       "[7.24, 0], [17.25, 0], [10.56, 6.24], [7.24, 6.24]",
       "[0, 6.24], [7.24, 6.24], [10.56, 6.24], [6.37, 10.25], [0, 10.25]",
       "[0, 10.25], [4.57, 10.25], [4.57, 15.41], [0, 15.41]", "[4.57, 10.25], [6.37, 10.25], [4.57, 15.41]"});
  const json answer = process::safety_answer(scene, hydrostatic::make);
  EXPECT_NEAR(answer["limit_analysis_factor"].get<double>(), 0.99913, 1e-5) << answer.dump(1);
  EXPECT_LT(answer["gap"].get<double>(), 1e-8);
  EXPECT_THAT(answer["limit_analysis_note"].get<std::string>(), HasSubstr("blocks wedge each other"));
}

/// Both take the flow as steady, and say the same where there is none.
TEST(SafetyWithoutAnswer, AFlowThatDoesNotSettleHasOneReasonForLevelAndFactor) {
  scene::Scene scene = dam_of_blocks(
      R"(analysis = { duration_s = 1, kind = "static" }
water = { upstream_level_m = 6, downstream_level_m = 4.21 }
joint = { friction_angle_deg = 20, uplift = "flow" }
)",
      {"[-30, -10], [50, -10], [50, 1], [26, 1], [26, 0], [14.27, 0], [8.44, 0], [8.44, -1.88], [0, -1.88], [-30, "
       "-1.88]",
       "[0, -1.88], [8.44, -1.88], [8.44, 0], [8.44, 5.69], [0, 5.69]",
       "[8.44, 0], [14.27, 0], [9.05, 5.69], [8.44, 5.69]",
       "[0, 5.69], [8.44, 5.69], [9.05, 5.69], [7.44, 12.97], [0, 12.97]",
       "[0, 12.97], [4.33, 12.97], [4.33, 19.14], [0, 19.14]", "[4.33, 12.97], [7.44, 12.97], [4.33, 19.14]"});
  const json factor = process::safety_answer(scene, hydrostatic::make);
  const json level = process::level_answer(scene, hydrostatic::make);
  EXPECT_EQ(factor["outcome"], "not found");
  EXPECT_EQ(level["outcome"], "not found");
  EXPECT_EQ(factor["why_no_factor"], level["reason"]);
  EXPECT_THAT(level["reason"].get<std::string>(),
              HasSubstr("\"blockweir run\" follows it with kind = \"transient\" in [joint_flow]"));
}

}  // namespace
}  // namespace blockweir::test::safety_without_answer_test
