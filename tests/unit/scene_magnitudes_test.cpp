// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Unusual magnitudes are warned of: each row of the table, and what is unusual beside something else.
#include <fmt/format.h>

#include <map>
#include <regex>

#include "bridge/scene/read/magnitudes.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_magnitudes_test {
using namespace blockweir::scene;
using sample::expect_warning;
using sample::text;
using sample::warnings;
using sample::with;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

/// Sets a key under a heading, in place of what stands there.
std::string set(std::string scene, const std::string& heading, const std::string& key, double value) {
  const auto at = scene.find(heading + "\n") + heading.size() + 1;
  const auto end = std::min(scene.find("\n[", at), scene.size());
  std::string body = scene.substr(at, end - at);
  body = std::regex_replace(body, std::regex("(^|\n)" + key + " = [^\n]*"), "$1");
  return scene.substr(0, at) + fmt::format("{} = {}\n", key, value) + body + scene.substr(end);
}

/// The sample with the key of a row set to a value, and what must go with it.
std::string set(const Magnitude& row, double value) {
  static const std::map<std::string, std::string> headings = {{"material.*", "[material.concrete]"},
                                                              {"analysis", "[analysis]"},
                                                              {"joint", "[joint]"},
                                                              {"water", "[water]"},
                                                              {"contact", "[contact]"},
                                                              {"load_case[]", "[[load_case]]"},
                                                              {"bolt[]", "[[bolt]]"},
                                                              {"ice", "[ice]"},
                                                              {"earthquake", "[earthquake]"},
                                                              {"silt", "[silt]"}};
  const std::string key = row.key;
  std::string scene = with("[water]", "[water]\natmosphere = \"wet-faces\"");
  if (row.section == std::string("analysis")) scene = scene.substr(0, scene.find("[water]"));
  if (key == "duration_s") scene = set(scene, "[analysis]", "step_s", value / 100);
  if (key == "roughness") scene = set(scene, "[joint]", "wall_strength_pa", 50e6);
  if (key == "wall_strength_pa") scene = set(scene, "[joint]", "roughness", 8);
  if (key == "step_s") scene = set(scene, "[analysis]", "duration_s", value * 100);
  scene +=
      "[[bolt]]\nname = \"bar\"\nfrom_block = \"base\"\nfrom_m = [0, 1]\nto_m = [-3, 0]\narea_m2_per_m = 1e-3\n"
      "youngs_modulus_pa = 210e9\n";
  if (row.section == std::string("ice")) scene += "[ice]\nthickness_m = 0.5\nthrust_n_per_m = 1e5\n";
  if (row.section == std::string("load_case[]")) {
    scene += "[[load_case]]\nname = \"flood\"\nset = [\"title=x\"]\nsource = \"a guideline\"\n";
  }
  if (row.section == std::string("earthquake")) scene += "[earthquake]\nhorizontal_coefficient = 0.1\n";
  if (row.section == std::string("silt")) scene += "[silt]\nlevel_m = 1\npressure_coefficient = 0.5\n";
  return set(scene, headings.at(row.section), key, value);
}

std::vector<std::string> complaints(const Magnitude& row, double value) {
  const std::string scene = set(row, value);
  const auto wrong = sample::errors(scene);
  return wrong.empty() ? warnings(scene) : wrong;
}

TEST(SceneMagnitudes, EachRowWarnsBelowAndAboveItsRangeAndNotInIt) {
  for (const Magnitude& row : magnitudes()) {
    const auto of_key = HasSubstr(fmt::format("{} in ", row.key));
    const double shrunk = row.grows_with_size ? 0.4 : 1;  // the sample is 4 m high
    EXPECT_THAT(complaints(row, std::sqrt(row.least * row.most)),
                Not(Contains(testing::AllOf(of_key, HasSubstr("unusual")))))
        << row.key;
    for (const double value : {0.9 * shrunk * row.least, 1.1 * row.most}) {
      // Beyond some ranges lies what cannot be: the reader refuses it.
      EXPECT_THAT(complaints(row, value), Contains(of_key)) << row.key << " = " << value;
    }
    const auto low = complaints(row, 0.9 * shrunk * row.least);
    EXPECT_THAT(low,
                Contains(testing::AllOf(HasSubstr(row.unit), HasSubstr(likely_meaning(row, 0.9 * shrunk * row.least)))))
        << row.key;
  }
}

TEST(SceneMagnitudes, WhatNoCalculationBearsIsRefused) {
  sample::expect_error(with("density_kg_per_m3 = 2500", "density_kg_per_m3 = 1e300"), 11,
                       {"density_kg_per_m3 in [material.concrete] is 1e+300 kg/m3",
                        "expected 0.0001 to 2e+10 kg/m3, usually 100 to 2e+04", "check its unit"});
  sample::expect_error(with("youngs_modulus_pa = 50e9", "youngs_modulus_pa = 1e-300"), 9,
                       {"youngs_modulus_pa in [material.concrete] is 1e-300 Pa"});
  sample::expect_error(with("cohesion_pa = 1e5", "cohesion_pa = 1e300"), 30,
                       {"cohesion_pa in [[joints]] \"crack\" is 1e+300 Pa", "0 to 1e+18 Pa"});
}

TEST(SceneMagnitudes, EachLawOfAJointIsLookedAt) {
  expect_warning(with("cohesion_pa = 1e5", "cohesion_pa = 300"), 30,
                 {"cohesion_pa in [[joints]] \"crack\" is 300 Pa, which is unusual", "if it is in kPa, write 300e3"});
  expect_warning(
      with("cohesion_pa = 1e5", "cohesion_pa = 100e6"), 30,
      {"cohesion_pa in [[joints]] \"crack\" is 1e+08 Pa, which is unusual", "5e+07 Pa", "joints of dams have"});
  EXPECT_THAT(warnings(with("cohesion_pa = 1e5", "cohesion_pa = 1e9")), Not(Contains(HasSubstr("unusual"))))
      << "blocks may be glued together";
  expect_warning(with("friction_angle_deg = 30", "friction_angle_deg = 0.6"), 13,
                 {"friction_angle_deg in [joint] is 0.6 deg, which is unusual", "expected 2 to 80 deg",
                  "if it is in radians, write 34.38"});
}

TEST(SceneMagnitudes, APoolDownstreamAloneIsNoPoolForUplift) {
  const auto downstream = [](const std::string& uplift) {
    return warnings(with("upstream_level_m", "downstream_level_m",
                         with("friction_angle_deg = 30", "friction_angle_deg = 30" + uplift)));
  };
  const auto is_told = Contains(HasSubstr("there is a downstream pool and no upstream one"));
  EXPECT_THAT(downstream("\nuplift = 'triangular'"), is_told);
  EXPECT_THAT(downstream("\nuplift = 'flow'"), Not(is_told));
  EXPECT_THAT(downstream(""), Not(is_told));
}

TEST(SceneMagnitudes, SiltAboveTheCrestIsADepth) {
  const std::string silt = "[silt]\nsubmerged_density_kg_per_m3 = 900\npressure_coefficient = 0.5\nlevel_m = ";
  expect_warning(text + silt + "4.5\n", 59, {"level_m in [silt] is 4.5 m, above the crest at 4 m", "not a depth"});
  EXPECT_THAT(warnings(text + silt + "3\n"), Not(Contains(HasSubstr("[silt]"))));
  expect_warning(text + "[silt]\nlevel_m = 1\npressure_coefficient = 0.5\nsubmerged_density_kg_per_m3 = 8.5\n", 59,
                 {"submerged_density_kg_per_m3 in [silt] is 8.5 kg/m3", "if it is in kN/m3, write 866.5"});
}

/// Of a dry scene: still water wants level ground.
TEST(SceneMagnitudes, ATiltIsUsualToEitherSide) {
  const std::string dry = text.substr(0, text.find("[water]"));
  const auto tilted = [&](const char* tilt) {
    return warnings(with("step_s = 0.01", std::string("step_s = 0.01\ngravity_tilt_deg = ") + tilt, dry));
  };
  EXPECT_THAT(tilted("-5"), IsEmpty());
  EXPECT_THAT(tilted("-0.2"), Contains(HasSubstr("gravity_tilt_deg in [analysis] is -0.2 deg, which is unusual")));
}

TEST(SceneMagnitudes, ANumberWithoutAUnitIsToldWithoutOne) {
  expect_warning(with("step_s = 0.01", "step_s = 0.01\nmax_displacement_ratio = 1e-9"), 6,
                 {"max_displacement_ratio in [analysis] is 1e-09, which is unusual; expected 1e-06 to 1; 1 % is 0.01"});
}

TEST(SceneMagnitudes, AWrongNumberIsToldAsItWasWritten) {
  sample::expect_error(with("poissons_ratio = 0.2", "poissons_ratio = 0.6"), 10,
                       {"poissons_ratio in [material.concrete] is 0.6; expected"});
}

/// The first of the row's units in which the user's own number would be usual.
TEST(SceneMagnitudes, TheLikelyMeaningIsToldOfTheNumberItself) {
  const auto modulus = [](const char* value) { return warnings(with("= 50e9", std::string("= ") + value)); };
  EXPECT_THAT(modulus("30"),
              Contains(HasSubstr("is 30 Pa, which is unusual; expected 4e+05 to 1e+13 Pa; if it is in GPa, "
                                 "write 30e9")));
  EXPECT_THAT(modulus("30000"), Contains(HasSubstr("if it is in MPa, write 30000e6")));
  EXPECT_THAT(modulus("1e14"), Contains(HasSubstr("check its unit")));
  EXPECT_THAT(warnings(with("= 2500", "= 23.5")), Contains(HasSubstr("if it is in kN/m3, write 2396")));
}

TEST(SceneMagnitudes, AStructureInCentimetresOnGroundInMetres) {
  const std::string pressed =
      "[[face_pressure]]\nblock = \"top\"\nfrom_m = [3, 2]\nto_m = [3, 4]\npressure_pa = 1000\n";
  const std::string huge =
      with("[[0, 2], [3, 2], [3, 4], [0, 4]]", "[[0, 2], [300, 2], [300, 400], [0, 400]]", with(pressed, ""));
  EXPECT_THAT(warnings(huge), Contains(HasSubstr("what can move is 300 m wide, and the fixed blocks 13 m")));
  EXPECT_THAT(warnings(huge), Contains(HasSubstr("upstream_level_m rises to 3 m above the foot of what can move, which "
                                                 "is 400 m high: 0.75 % of it")));
}

TEST(SceneMagnitudes, NothingAtAllIsUsual) {
  EXPECT_THAT(warnings(with("friction_angle_deg = 30", "friction_angle_deg = 0\ncohesion_pa = 0",
                            with("poissons_ratio = 0.2", "poissons_ratio = 0"))),
              IsEmpty());
}

TEST(SceneMagnitudes, AModelHasLessStressThanADam) {
  const std::string weak = with("cohesion_pa = 1e5", "cohesion_pa = 500");
  EXPECT_THAT(warnings(weak), IsEmpty());  // 4 m
  EXPECT_THAT(warnings(with("cohesion_pa = 1e5", "cohesion_pa = 300")), testing::SizeIs(1));
}

TEST(SceneMagnitudes, MoreStepsThanCanBeCountedAreAnError) {
  sample::expect_error(with("step_s = 0.01", "step_s = 1e-300"), 4, {"takes 2e+300 steps", "lengthen step_s"});
}

TEST(SceneMagnitudes, MoreStepsThanARunCanMake) {
  expect_warning(
      with("duration_s = 2.0", "duration_s = 2e6", with("table = [[0, 1], [2, 3]]", "table = [[0, 1], [1e6, 3]]")), 4,
      {"duration_s 2e+06 in steps of 0.01 s takes 2e+08 steps", "shorten duration_s"});
  EXPECT_THAT(warnings(with("duration_s = 2.0", "duration_s = 1e12")), Contains(HasSubstr("a year is 3e7 s")));
}

/// The structure of the sample alone, its coordinates times a factor.
std::string scaled(double factor) {
  const std::string scene = text.substr(0, text.find("[[joints]]"));
  std::string grown;
  const auto from = scene.find("[[block]]");
  grown = scene.substr(0, from);
  const std::regex number("-?[0-9]+");
  const std::string rest = scene.substr(from);
  auto last = rest.begin();
  for (std::sregex_iterator i(rest.begin(), rest.end(), number), end; i != end; ++i) {
    grown.append(last, (*i)[0].first);
    grown += fmt::format("{}", factor * std::stod((*i)[0].str()));
    last = (*i)[0].second;
  }
  return grown.append(last, rest.end());
}

TEST(SceneMagnitudes, AStructureInMillimetres) {
  EXPECT_THAT(warnings(scaled(1)), IsEmpty());
  expect_warning(scaled(4000), 14, {"the structure is 1.6e+04 m large", "millimetres? write metres"});
  expect_warning(scaled(1e-4), 14, {"the structure is 0.0004 m large", "kilometres? write metres"});
}

TEST(SceneMagnitudes, AnEarthquakeInCentimetresPerSecondSquared) {
  EXPECT_THAT(
      warnings(text + "[base_motion]\nacceleration_x_m_per_s2 = { sine = 200, frequency_hz = 2 }\n"),
      testing::Contains(testing::AllOf(HasSubstr("s.toml:57: warning: acceleration_x_m_per_s2 in [base_motion] reaches "
                                                 "200 m/s2"),
                                       HasSubstr("scale = 0.01"))));
}

TEST(SceneMagnitudes, ALevelFasterThanAWave) {
  expect_warning(with("[[0, 1], [2, 3]]", "[[0, 1], [0.1, 3]]"), 45,
                 {"upstream_level_m goes from 1 to 3 m within 0.1 s", "20 m/s, faster than a wave", "steps ="});
  EXPECT_THAT(warnings(with("table = [[0, 1], [2, 3]]", "steps = [[0, 1], [0.1, 3]]")), IsEmpty());
}

TEST(SceneMagnitudes, ALevelThatTheRunDoesNotComeTo) {
  expect_warning(with("[[0, 1], [2, 3]]", "[[0, 1], [4, 3]]"), 45,
                 {"upstream_level_m never reaches its 3 m at 4 s: the run ends after 2 s, at 2 m",
                  "lengthen duration_s, or raise the level faster"});
  expect_warning(with("table = [[0, 1], [2, 3]]", "from = 1, rate_per_s = 0.5, to = 3"), 45,
                 {"never reaches its 3 m at 4 s"});
  expect_warning(with("[[0, 1], [2, 3]]", "[[-2, 0.5], [0, 1], [2, 3]]"), 45,
                 {"never reaches its 0.5 m at -2 s: the run begins at 0 s"});
}

TEST(SceneMagnitudes, TailwaterAboveHeadwater) {
  expect_warning(with("[fluid]", "downstream_level_m = 2\n[fluid]"), 46,
                 {"downstream_level_m is 2 m at 0 s and upstream_level_m 1 m", "are the two exchanged?"});
}

TEST(SceneMagnitudes, AGapBetweenBlocksThatSeemMeantToTouch) {
  const std::string top = "[[0, 2], [3, 2], [3, 4], [0, 4]]";
  const std::string raised = with(top, "[[0, 2.02], [3, 2.02], [3, 4], [0, 4]]", scaled(1));
  expect_warning(
      raised, 23,
      {"blocks \"base\" and \"top\" have a gap of 0.02 m between them", "unusual for a structure that begins at rest"});
  EXPECT_THAT(warnings(raised)[0], Not(HasSubstr("uplift")));
  expect_warning(with("[joint]", "[water]\nupstream_level_m = 1\n[joint]\nuplift = \"triangular\"", raised), 26,
                 {"the uplift \"triangular\" acts only in a joint whose faces touch: none acts here"});
  EXPECT_THAT(warnings(with("step_s = 0.01", "step_s = 0.01\nstart = \"unstressed\"", raised)), IsEmpty());
  const std::string mortar =
      "[[block]]\nname = \"mortar\"\nmaterial = \"concrete\"\nvertices_m = [[0, 2], [3, 2], [3, 2.02], [0, 2.02]]\n";
  EXPECT_THAT(warnings(raised + mortar), Not(Contains(HasSubstr("have a gap"))));
  EXPECT_THAT(warnings(with(top, "[[0, 2.5], [3, 2.5], [3, 4], [0, 4]]", scaled(1))), IsEmpty());  // to fall
}

TEST(SceneMagnitudes, StrictMakesErrorsOfWarnings) {
  const auto read = read_text(with("density_kg_per_m3 = 2500", "density_kg_per_m3 = 2.4"), "s.toml");
  EXPECT_NO_THROW(refuse_warnings({}));
  try {
    refuse_warnings(read.warnings);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(),
                 "s.toml:11: error: density_kg_per_m3 in [material.concrete] is 2.4 kg/m3, which is unusual; expected "
                 "100 to 2e+04 kg/m3; if it is in t/m3, write 2400");
  }
  EXPECT_THAT(read.scene.warnings, testing::ElementsAre(HasSubstr("if it is in t/m3, write 2400")));
}

}  // namespace
}  // namespace blockweir::scene_magnitudes_test
