// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json
// Structures drawn at random: the level that is found without a run, by rigid blocks and by limit analysis, against
// limit equilibrium and limit analysis that share no code with the program.
#include <fstream>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/capacity/static_level.hpp"
#include "tests/verification/random_trials.hpp"

namespace blockweir::test::random_levels_test {
namespace {

class RandomLevels : public RandomTrials {
 protected:
  /// Without strain; the reservoir stands on the left.
  [[nodiscard]] scene::Scene scene_of(const RandomStructure& one, double level_m) const {
    const Structure structure = one.structure.reservoir_right ? mirrored(one.structure) : one.structure;
    const Filling filling{.rigid = "all", .duration_s = 1, .levels = {{0, level_m}}};
    const std::string text = scene_text(structure, filling);
    std::ofstream(folder / "scene.toml") << text;  // for BLOCKWEIR_KEEP
    return scene::read_text(text, "scene.toml").scene;
  }
  [[nodiscard]] nlohmann::json level_of(const RandomStructure& one) const {
    return process::level_answer(scene_of(one, one.level_m), hydrostatic::make);
  }
  /// All three ways to a level.
  [[nodiscard]] std::string wrong_levels(const RandomStructure& one) const {
    const nlohmann::json answer = level_of(one);
    std::string all = wrong_level("limit analysis", answer["limit_analysis"], one.level_m) +
                      wrong_level("blocks", answer, one.level_m);
    const double gap = answer["limit_analysis"].value("gap", 1.0);
    if (!(gap <= 1e-8)) all += fmt::format("gap {:.3g}; ", gap);
    return all;
  }
  /// What is wrong with a level; empty where nothing is.
  static std::string wrong_level(const char* whose, const nlohmann::json& found, double level_m) {
    if (!found["level_m"].is_number()) {
      return fmt::format("{}: {}, {:.9g} m is right; ", whose, found["outcome"].get<std::string>(), level_m);
    }
    const double off = found["level_m"].get<double>() / level_m - 1;
    constexpr double allowed = 1e-6;
    return std::abs(off) <= allowed ? "" : fmt::format("{}: off by {:.3g}; ", whose, off);
  }
};

TEST_F(RandomLevels, RigidBlocksLimitAnalysisAndHandFormulaAgree) {
  each({monolith, lifts, anchored}, 12, [this](const RandomStructure& one) { return wrong_levels(one); });
}

TEST_F(RandomLevels, GravitySectionsWithEachLawOfUpliftAgree) {
  each({gravity_section}, 200, [this](const RandomStructure& one) { return wrong_levels(one); });
}

/// Below the level of failure; where the joint is pressed over its length, what is reduced decides by sliding.
TEST_F(RandomLevels, StrengthReductionIsTheSlidingFactorByHand) {
  each({gravity_section}, 40, [this](const RandomStructure& one) {
    const double level_m = 0.9 * one.level_m;
    const double factor = sliding_factor(one.stacks.front(), level_m);
    const nlohmann::json answer = process::safety_answer(scene_of(one, level_m), hydrostatic::make);
    std::string all;
    for (const char* whose : {"factor", "limit_analysis_factor"}) {
      if (!answer[whose].is_number()) {
        all += fmt::format("{}: none, {:.9g} is right; ", whose, factor);
        continue;
      }
      const double off = answer[whose].get<double>() / factor - 1;
      if (!(std::abs(off) <= 1e-6)) all += fmt::format("{}: off by {:.3g}; ", whose, off);
    }
    return all;
  });
}

/// 5 % below the level of failure a run tells its margin of the surface on which the blocks then fail.
TEST_F(RandomLevels, TheMarginIsToldOfTheSurfaceThatFailsWhenTheLevelIsRaised) {
  int told = 0;
  each({on_rock, bricks, voronoi}, 4, [&](const RandomStructure& one) {
    constexpr double coarse = 1e-3;
    const scene::Scene scene = scene_of(one, one.level_m);
    solid::StillWater water(scene, hydrostatic::make);
    const auto failing = solid::attempt([&] { return solid::static_level(scene, water, coarse); });
    if (!failing.value || !failing.value->failure) return std::string();
    const scene::Scene below = scene_of(one, 0.95 * one.level_m);
    const nlohmann::json margin = process::margin_answer(below, hydrostatic::make);
    if (!margin.contains("mechanism")) return std::string();
    ++told;
    const auto joints = margin["mechanism"]["joints"].get<std::vector<std::string>>();
    const std::string& fails = failing.value->failure->joint;
    const bool same = std::find(joints.begin(), joints.end(), fails) != joints.end();
    return same ? "" : fmt::format("fails on \"{}\", the margin is of {}; ", fails, margin["mechanism"]["text"].dump());
  });
  EXPECT_GT(told, 0);
  std::cout << "margins of jointed dams: " << told << "\n";
}

/// Joints that open as they slip, by tan(phi) of it, and keep their bond obey limit analysis.
TEST_F(RandomLevels, BlocksWhoseDilationIsTheirFrictionFailAtTheLevelOfLimitAnalysis) {
  each({monolith, lifts, on_rock, bricks}, 3, [&](const RandomStructure& one) {
    constexpr double width = 1e-6;
    scene::Scene scene = scene_of(one, one.level_m);
    const auto dilate = [](scene::JointLaw& law) {
      law.dilation_angle_deg = law.friction_angle_deg;
      law.keeps_cohesion = true;
    };
    dilate(scene.default_joint);
    for (scene::Joint& joint : scene.joints) dilate(joint.law);
    solid::StillWater water(scene, hydrostatic::make);
    const solid::StaticLevel found = solid::static_level(scene, water, width);
    const double off = found.level_m - one.level_m;
    const double rise_m = water.range().full_m - water.range().empty_m;
    return found.failure && std::abs(off) <= 2 * width * rise_m ? "" : fmt::format("off by {:.3g} m; ", off);
  });
}

TEST_F(RandomLevels, LimitAnalysisOfJointedDamsIsTheIndependentOne) {
  each({on_rock, bricks, voronoi}, 4, [this](const RandomStructure& one) {
    const nlohmann::json answer = level_of(one);
    const nlohmann::json& limit = answer["limit_analysis"];
    // Cells without cohesion may need the water's push: those that slide upstream stand between two levels.
    if (limit["outcome"] == "does not stand empty" && answer["outcome"] == limit["outcome"]) return std::string();
    return wrong_level("limit analysis", limit, one.level_m);
  });
}

}  // namespace
}  // namespace blockweir::test::random_levels_test
