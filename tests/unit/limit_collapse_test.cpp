// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit bridge_scene_read
// What no strength holds has a mechanism, too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/scene/read/read.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/limit/limit_level.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/limit/mechanism_description.hpp"

namespace blockweir::solid::limit::limit_collapse_test {
namespace {

/// Level ground, and blocks on it.
scene::Scene on_ground(double tilt_deg, double friction_deg, const std::string& blocks) {
  return scene::read_text(fmt::format(R"(analysis = {{ duration_s = 1, gravity_tilt_deg = {} }}
joint = {{ friction_angle_deg = {} }}
material.stone = {{ youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }}
[[block]]
name = "ground"
material = "stone"
fixed = true
vertices_m = [[-20, -1], [20, -1], [20, 0], [-20, 0]]
{})",
                                      tilt_deg, friction_deg, blocks),
                          "ground")
      .scene;
}

scene::Scene leaning(double breadth, double height, double friction_deg, double tilt_deg) {
  return on_ground(tilt_deg, friction_deg,
                   fmt::format(R"([[block]]
name = "idle"
material = "stone"
vertices_m = [[-15, 0], [-9, 0], [-9, 1], [-15, 1]]
[[block]]
name = "tower"
material = "stone"
vertices_m = [[0, 0], [{0}, 0], [{0}, {1}], [0, {1}]]
)",
                               breadth, height));
}

/// It leaves the rock behind it as it slides: only the base is slid on.
TEST(LimitCollapse, TheWordsOfAMechanismTellAJointThatOpensFromOneThatIsSlidOn) {
  const scene::Scene scene = on_ground(0, 30, R"([[block]]
name = "rock behind"
material = "stone"
fixed = true
vertices_m = [[-5, 0], [0, 0], [0, 1], [-5, 1]]
[[block]]
name = "wall"
material = "stone"
vertices_m = [[0, 0], [1, 0], [1, 4], [0, 4]]
[[joints]]
name = "base"
between = ["ground", "wall"]
[[joints]]
name = "back"
between = ["rock behind", "wall"]
)");
  const LimitAnalysis structure(scene);
  Twists slides(scene.blocks.size(), Twists::value_type::Zero());
  slides[2] = {0.86, 0.5, 0};
  EXPECT_EQ(words_of(structure, slides).text, "block \"wall\" slides on joint \"base\"; joint \"back\" opens");
}

/// The power of the loads is more than all that joints of any strength take up: none, where nothing slips.
TEST(LimitCollapse, ATowerThatOverturnsWhateverItsFrictionTurnsAboutItsToeAndNothingElseMoves) {
  const scene::Scene scene = leaning(0.5, 4, 45, 20);
  const LimitAnalysis structure(scene);
  const Wrenches weights = statics::weights_of(scene);
  const LimitStrength found = limit_strength(structure, weights);
  ASSERT_EQ(found.bearing, Bearing::bears_none);
  const MechanismDescription words = words_of(structure, found.mechanism);
  EXPECT_EQ(words.mode, "overturning") << words.text;
  EXPECT_EQ(words.moving, std::vector<std::size_t>{2}) << words.text;
  EXPECT_GT(power(weights, found.mechanism), 0);
  EXPECT_NEAR(structure.resistance(found.mechanism, 1e-6), 0, 1e-9 * power(weights, found.mechanism));
}

TEST(LimitCollapse, WithoutAnyFrictionWhatSlidesHasItsMechanism) {
  const scene::Scene scene = leaning(4, 1, 0, 20);
  const LimitAnalysis structure(scene);
  const LimitStrength found = limit_strength(structure, statics::weights_of(scene));
  ASSERT_EQ(found.bearing, Bearing::bears_none);
  const MechanismDescription words = words_of(structure, found.mechanism);
  EXPECT_EQ(words.mode, "sliding") << words.text;
  EXPECT_GT(power(statics::weights_of(scene), found.mechanism), 0);
}

/// Dividing no strength by anything leaves it as it is.
TEST(LimitCollapse, WithoutAnyStrengthItBearsAnyReductionOrNone) {
  for (const double breadth : {0.5, 1.0, 2.0, 4.0}) {
    for (const double tilt_deg : {0.0, 1e-3, 5.0, 20.0}) {
      const scene::Scene scene = leaning(breadth, 1, 0, tilt_deg);
      const LimitAnalysis structure(scene);
      EXPECT_FALSE(structure.has_shear_strength());
      const LimitStrength found = limit_strength(structure, statics::weights_of(scene));
      EXPECT_EQ(found.bearing, tilt_deg == 0 ? Bearing::bears_any : Bearing::bears_none) << breadth << " " << tilt_deg;
    }
  }
}

TEST(LimitCollapse, WhatDoesNotStandEmptyHasTheMechanismOfItsOwnStrength) {
  const scene::Scene scene = leaning(4, 1, 10, 20);
  const LimitAnalysis structure(scene);
  const Wrenches weights = statics::weights_of(scene);
  const auto none = [&](double) { return Wrenches(scene.blocks.size(), Wrench::Zero()); };
  const LimitLevel found = limit_level(structure, weights, none, {0, 1});
  ASSERT_EQ(found.outcome, Filled::does_not_stand_empty);
  EXPECT_EQ(words_of(structure, found.at_it.mechanism).mode, "sliding");
  EXPECT_GT(power(weights, found.at_it.mechanism), structure.resistance(found.at_it.mechanism));
}

}  // namespace
}  // namespace blockweir::solid::limit::limit_collapse_test
