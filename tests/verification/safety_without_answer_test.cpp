// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Where `safety` has no factor it says why, and what it says is true.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json safety_of(const std::string& modulus_pa, const std::string& more) {
  const std::string text = fmt::format(R"(analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 40 }}
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
                                       modulus_pa, more);
  return process::safety_answer(scene::read_text(text, "wall.toml").scene, hydrostatic::make);
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

}  // namespace
}  // namespace blockweir::test
