// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Wrong keys, types and values of a scene: each message with its line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_keys_test {
using blockweir::scene::sample::errors;
using blockweir::scene::sample::expect_error;
using blockweir::scene::sample::text;
using blockweir::scene::sample::with;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

TEST(SceneKeys, TheSampleIsSound) {
  EXPECT_THAT(errors(text), IsEmpty());
}

TEST(SceneKeys, ASyntaxErrorNamesItsLine) {
  expect_error(with("step_s = 0.01", "step_s = 0.01.2"), 5, {"a syntax error", "expected TOML"});
}

TEST(SceneKeys, ADecimalCommaIsToldAsOne) {
  expect_error(with("poissons_ratio = 0.2", "poissons_ratio = 0,2"), 10, {"write 0.2 with a decimal point"});
  expect_error(with("poissons_ratio = 0.2", "poissons_ratio = \"0,2\""), 10, {"write 0.2 with a decimal point"});
  const auto set = errors(text, {"joint.friction_angle_deg=30,5"});
  ASSERT_THAT(set, SizeIs(1));
  EXPECT_THAT(set[0], HasSubstr("write 30.5 with a decimal point"));
  expect_error(with("[3, 4], [0, 4]]\n[[joints]]", "[3, 4,5], [0, 4]]\n[[joints]]"), 26, {"2.5, not 2,5"});
}

TEST(SceneKeys, ACornerThatIsNoNumberIsToldAsThat) {
  for (const char* number : {"nan", "inf"}) {
    expect_error(with("[3, 4], [0, 4]]\n[[joints]]", std::string("[3, ") + number + "], [0, 4]]\n[[joints]]"), 26,
                 {std::string("is ") + number, "expected a finite number"});
  }
}

TEST(SceneKeys, AnUnknownKeyNamesTheNearest) {
  expect_error(with("max_iterations", "max_iteration"), 7,
               {"unknown key \"max_iteration\" in [contact]", "did you mean \"max_iterations\"?"});
}

TEST(SceneKeys, AnUnknownKeyWithoutRelativesListsTheRightOnes) {
  expect_error(with("max_iterations = 100", "zebra = 100"), 7, {"one of formulation, "});
}

TEST(SceneKeys, AnUnknownSectionNamesTheNearest) {
  expect_error(with("[contact]\nmax_iterations = 100", "[contacts]\n"), 6,
               {"unknown section \"contacts\"", "did you mean \"contact\"?"});
  expect_error("titel = \"a\"\n" + text, 1, {"unknown key \"titel\"", "did you mean \"title\"?"});
}

TEST(SceneKeys, AWrongUnitNamesTheRightOne) {
  const auto density = errors(with("density_kg_per_m3", "density_kg_m3"));
  ASSERT_THAT(density, SizeIs(2));
  EXPECT_THAT(density[0], HasSubstr("s.toml:8: error: [material.concrete] has no \"density_kg_per_m3\""));
  EXPECT_THAT(density[1],
              HasSubstr("s.toml:11: error: unknown key \"density_kg_m3\" in [material.concrete]; expected "
                        "density_kg_per_m3, in kg/m3; write density_kg_per_m3 and give the value in kg/m3"));
  expect_error(with("friction_angle_deg", "friction_angle_rad"), 13, {"expected friction_angle_deg, in deg;"});
  expect_error(with("[water]", "[water]\nlevel_mm = 3"), 45, {"unknown key \"level_mm\"", "upstream_level_m, in m;"});
  expect_error(with("step_s = 0.01", "step = 0.01"), 5, {"expected step_s, in s;"});
  expect_error(with("window_s", "window_ms"), 49, {"expected window_s, in s;"});
  EXPECT_THAT(errors(with("[water]", "[ice]\nthrust_kn_per_m = 150\nthickness_m = 0.5\n[water]")),
              testing::Contains(HasSubstr("write thrust_n_per_m and give the value in N/m")));
}

TEST(SceneKeys, TheBeginningOfAKeyNamesIt) {
  expect_error(with("friction_angle_deg", "friction"), 13, {"unknown key", "did you mean \"friction_angle_deg\"?"});
}

TEST(SceneKeys, KeysOfAnotherContactFormulationAreRefused) {
  expect_error(with("max_iterations = 100", "dashpot_ratio = 0.1"), 7,
               {"dashpot_ratio belongs to another formulation", "expected formulation = \"penalty\" beside it"});
  EXPECT_THAT(errors(with("max_iterations = 100", "formulation = \"penalty\"\nstiffness_n_per_m2 = 1e12")), IsEmpty());
}

TEST(SceneKeys, ATensionBeyondTheEndOfMohrCoulombsLawIsNoted) {
  const auto read = blockweir::scene::read_text(with("[joint]\n", "[joint]\ntension_strength_pa = 1e5\n"), "s.toml");
  ASSERT_THAT(read.notes, SizeIs(1));
  EXPECT_THAT(read.notes[0].text(), HasSubstr("more than cohesion over tan(friction angle); "));
}

TEST(SceneKeys, AMissingKeyIsNamed) {
  expect_error(with("duration_s = 2.0\n", ""), 3, {"[analysis] has no \"duration_s\"", "add duration_s = ..."});
  expect_error(with("poissons_ratio = 0.2\n", ""), 8, {"[material.concrete] has no \"poissons_ratio\""});
  expect_error(with("name = \"crack\"\n", "", with("of = \"crack\"\n", "")), 27, {"[[joints]] has no \"name\""});
  expect_error(with("point_m = [0, 4]\n", ""), 35, {"[[point_load]] has no \"point_m\""});
}

TEST(SceneKeys, AWrongTypeIsNamed) {
  expect_error(with("step_s = 0.01", "step_s = \"fast\""), 5, {"step_s in [analysis] is 'fast'", "a number above 0"});
  expect_error(with("step_s = 0.01", "step_s = \"1\""), 5,
               {"step_s in [analysis] is the text '1'; expected a number above 0; take off the quotes"});
  expect_error(with("fixed = true", "fixed = \"true\""), 17, {"is the text 'true'", "take off the quotes"});
  expect_error(with("fixed = true", "fixed = 1"), 17, {"fixed in [[block]] \"ground\" is 1", "true or false"});
  expect_error(with("max_iterations = 100", "max_iterations = 1.5"), 7, {"is 1.5", "a whole number from 1"});
  expect_error(with("name = \"crack\"", "name = 7", with("of = \"crack\"\n", "")), 28, {"is 7", "a text"});
  expect_error(with("point_m = [0, 4]", "point_m = [0, 4, 1]"), 37, {"is a list of 3", "a pair of numbers"});
  expect_error(with("point_m = [0, 4]", "point_m = 4"), 37, {"is 4", "a pair of numbers"});
  expect_error(with("point_m = [0, 4]", "point_m = [0, \"4\"]"), 37,
               {"y of point_m in [[point_load]] is the text '4'; expected a finite number; take off the quotes"});
  expect_error(with("title = \"sample\"", "title = 3"), 1, {"title is not a text"});
  expect_error(with("between = [\"base\", \"top\"]", "between = [\"base\"]"), 29, {"a list of 2 names"});
}

TEST(SceneKeys, ASectionOfTheWrongKindIsNamed) {
  expect_error(with("[contact]\nmax_iterations = 100", "[[contact]]\n"), 6, {"contact is not a section", "[contact]"});
  expect_error(with("[[expect]]", "[expect]"), 52, {"expect is not a list of sections", "[[expect]]"});
  expect_error(with("[joint]", "[material]\nsteel = 7\n[joint]"), 13, {"material.steel is not a section"});
}

TEST(SceneKeys, ANumberThatIsNotFiniteIsRefused) {
  for (const char* value : {"inf", "-inf", "nan"}) {
    expect_error(with("step_s = 0.01", fmt::format("step_s = {}", value)), 5,
                 {"step_s in [analysis] is", "expected a finite number"});
  }
  expect_error(with("pressure_pa = 1000", "pressure_pa = nan"), 43, {"pressure_pa in [[face_pressure]] is nan"});
  expect_error(with("point_m = [0, 4]", "point_m = [0, inf]"), 37, {"is inf", "expected a finite number"});
  expect_error(with("point_m = [0, 4]", "point_m = [0, 9007199254740993]"), 37,
               {"y of point_m in [[point_load]] is 9007199254740993; expected a number within 1e7, in metres"});
}

TEST(SceneKeys, NumbersOutOfRangeAreRefused) {
  expect_error(with("density_kg_per_m3 = 2500", "density_kg_per_m3 = -5"), 11, {"is -5", "a number above 0"});
  expect_error(with("youngs_modulus_pa = 50e9", "youngs_modulus_pa = -1"), 9, {"is -1", "a number above 0"});
  expect_error(with("poissons_ratio = 0.2", "poissons_ratio = 0.5"), 10, {"below 0.5 (plane strain)"});
  expect_error(with("poissons_ratio = 0.2", "poissons_ratio = -0.1"), 10, {"at least 0"});
  expect_error(with("friction_angle_deg = 30", "friction_angle_deg = 90"), 13, {"is 90", "below 90 degrees"});
  expect_error(with("friction_angle_deg = 30", "friction_angle_deg = -1"), 13, {"at least 0 and below 90"});
  expect_error(with("cohesion_pa = 1e5", "cohesion_pa = -1"), 30, {"cohesion_pa in [[joints]] \"crack\" is -1"});
  expect_error(with("cohesion_pa = 1e5", "tension_strength_pa = -1"), 30, {"tension_strength_pa", "at least 0"});
  expect_error(with("duration_s = 2.0", "duration_s = 0"), 4, {"duration_s", "above 0"});
  expect_error(with("window_s = 0.02", "window_s = -0.02"), 49, {"window_s", "above 0"});
  expect_error(with("[water]", "[water]\nelements_per_face = 0"), 45, {"elements_per_face", "from 1 to"});
  expect_error(with("step_s = 0.01", "residual_tolerance = 0"), 5, {"residual_tolerance", "above 0"});
  expect_error(with("step_s = 0.01", "kind = \"statical\""), 5, {"did you mean \"static\"?"});
  expect_error(with("step_s = 0.01", "spectral_radius = 1.1"), 5, {"a number from 0 to 1"});
}

TEST(SceneKeys, DilationBeyondFrictionWouldMakeEnergyAndIsRefused) {
  const std::string dilates = "friction_angle_deg = 30\ndilation_angle_deg = ";
  expect_error(with("friction_angle_deg = 30", dilates + "31"), 14,
               {"dilation_angle_deg in [joint] is 31, above friction_angle_deg = 30", "slip would then create energy",
                "set dilation_angle_deg to at most 30"});
  EXPECT_THAT(errors(with("friction_angle_deg = 30", dilates + "30")), IsEmpty());
  expect_error(with("cohesion_pa = 1e5", "dilation_angle_deg = 20\nresidual_friction_angle_deg = 15"), 30,
               {"[[joints]] \"crack\" is 20, above residual_friction_angle_deg = 15"});
  expect_error(with("cohesion_pa = 1e5", "friction_angle_deg = 10", with("friction_angle_deg = 30", dilates + "20")),
               31, {"[[joints]] \"crack\" is 20, above friction_angle_deg = 10"});
}

TEST(SceneKeys, PlaneStressAllowsAPoissonsRatioOfAHalf) {
  const std::string stress = with("step_s = 0.01", "step_s = 0.01\nplane = \"stress\"");
  EXPECT_THAT(errors(with("poissons_ratio = 0.2", "poissons_ratio = 0.5", stress)), IsEmpty());
  expect_error(with("poissons_ratio = 0.2", "poissons_ratio = 0.51", stress), 11, {"from 0 to 0.5 (plane stress)"});
}

TEST(SceneKeys, AWrongWordNamesTheNearest) {
  expect_error(with("model = \"hydrostatic\"", "model = \"hydrostatics\""), 47,
               {"model in [fluid] is \"hydrostatics\"", "one of none, hydrostatic", "did you mean \"hydrostatic\"?"});
}

TEST(SceneKeys, AStepOrWindowLongerThanTheRunIsRefused) {
  expect_error(with("step_s = 0.01", "step_s = 3"), 5, {"step_s 3 is longer than duration_s 2"});
  expect_error(with("window_s = 0.02", "window_s = 5"), 49, {"window_s 5 is longer than duration_s 2"});
}

TEST(SceneKeys, NamesThatNothingHasNameTheNearest) {
  expect_error(with("block = \"base\"", "block = \"bsae\""), 32,
               {"block in [[support]] names no block: \"bsae\"", "one of ground, base, top", "did you mean \"base\"?"});
  expect_error(with("between = [\"base\", \"top\"]", "between = [\"base\", \"tpo\"]"), 29,
               {"between in [[joints]] \"crack\" names no block: \"tpo\"", "did you mean \"top\"?"});
  expect_error(with("of = \"crack\"", "of = \"crak\""), 55, {"names no block, joint or bolt: \"crak\"", "\"crack\""});
  expect_error(with("\"concrete\"\nfixed", "\"concret\"\nfixed"), 16,
               {"material in [[block]] \"ground\" names no material: \"concret\"", "did you mean \"concrete\"?"});
}

TEST(SceneKeys, NamesAreGivenOnce) {
  expect_error(with("name = \"top\"", "name = \"base\"",
                    with("of = \"crack\"\n", "",
                         with("\"top\"]", "\"ground\"]",
                              with("block = \"top\"\npoint_m = [0, 4]", "block = \"base\"\npoint_m = [0, 2]",
                                   with("block = \"top\"\nfrom_m = [3, 2]\nto_m = [3, 4]",
                                        "block = \"base\"\nfrom_m = [3, 0]\nto_m = [3, 2]"))))),
               24, {"a second block is called \"base\"", "rename"});
  const std::string joint = "[[joints]]\nname = \"{}\"\nbetween = [\"{}\", \"{}\"]\n[[support]]";
  expect_error(with("[[support]]", fmt::format(fmt::runtime(joint), "crack", "base", "ground")), 32,
               {"a second joint is called \"crack\""});
  expect_error(with("[[support]]", fmt::format(fmt::runtime(joint), "other", "top", "base")), 33,
               {"is a second joint of its two blocks"});
  expect_error(with("[[support]]", fmt::format(fmt::runtime(joint), "self", "top", "top")), 33,
               {"joins block \"top\" to itself"});
}

TEST(SceneKeys, ASceneWithoutBlocksOrMaterialsIsRefused) {
  const auto found = errors("[analysis]\nduration_s = 1\n");
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_THAT(found[0], HasSubstr("s.toml: error: the scene has no material; expected [material.NAME]"));
  EXPECT_THAT(found[1], HasSubstr("s.toml: error: the scene has no block; expected [[block]]"));
}

TEST(SceneKeys, ExpectationsHaveExactlyOneFigure) {
  expect_error(with("value = 1.0\n", ""), 52, {"[[expect]] has no answer", "exactly one of value, word and formula"});
  expect_error(with("value = 1.0", "value = 1.0\nformula = \"weight-of-all\""), 52,
               {"[[expect]] has both value and formula"});
}

TEST(SceneKeys, WhatIsExpectedIsAFigureThatThereIs) {
  expect_error(with("quantity = \"failure_head_m\"", "quantity = \"failure_haed_m\""), 53,
               {"quantity in [[expect]] is \"failure_haed_m\"", "did you mean \"failure_head_m\"?"});
  expect_error(with("value = 1.0", "formula = \"plane-crack\""), 54,
               {"formula in [[expect]] is \"plane-crack\"", "expected one of"});
}

TEST(SceneKeys, EveryProblemIsReportedAtOnceInOrderOfLines) {
  const auto found =
      errors(with("point_m = [0, 4]", "point_m = [9, 9]",
                  with("max_iterations", "iterations", with("poissons_ratio = 0.2", "poissons_ratio = 2"))));
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_THAT(found[0], HasSubstr("s.toml:7: "));
  EXPECT_THAT(found[1], HasSubstr("s.toml:10: "));
  EXPECT_THAT(found[2], HasSubstr("s.toml:37: "));
}

TEST(SceneKeys, EveryErrorSaysWhatIsExpectedAndWhatToDo) {
  try {
    blockweir::scene::read_text("a = 1\nblock = [{}]\n[material.m]\n[[support]]\n[[face_pressure]]\n[water]\n",
                                "s.toml");
    FAIL() << "read a scene that has nothing";
  } catch (const blockweir::scene::SceneError& error) {
    EXPECT_GT(error.diagnostics().size(), 10u);
    for (const auto& d : error.diagnostics()) {
      EXPECT_FALSE(d.expected.empty()) << d.text();
      EXPECT_EQ(d.file, "s.toml");
    }
  }
}

TEST(SceneKeys, AKeyTooDeepForTheParserIsRefused) {
  std::string key = "a";
  for (int i = 0; i < 1'000'000; ++i) key += ".a";
  expect_error("# a.b\ntitle = 'x.y.z'\n" + key + " = 1\n", 3, {"a key of 1000001 parts"});
  expect_error("t = \"\"\"\n\"a\"\"\"\"\nx = { \"],\"." + key + " = 1 }\n", 3, {"a key of 1000002 parts"});
}

TEST(SceneKeys, AFileOfNothingButErrorsIsCutShort) {
  std::string scene;
  for (int i = 0; i < 100'000; ++i) scene += fmt::format("k{} = 1\n", i);
  EXPECT_THAT(errors(scene), SizeIs(200));
}

TEST(SceneKeys, VariantsHaveANameOfTheirOwnAndAListOfTexts) {
  const std::string slow = "[[variant]]\nname = \"slow\"\nset = [\"analysis.duration_s=9\"]\n";
  EXPECT_THAT(errors(text + slow), testing::IsEmpty());
  expect_error(text + slow + slow, 60, {"a second variant is called \"slow\"", "rename one of them"});
  expect_error(text + "[[variant]]\nname = \"slow\"\n", 56, {"[[variant]] \"slow\" has no \"set\""});
  expect_error(text + "[[variant]]\nname = \"slow\"\nset = [7]\n", 58,
               {"set in [[variant]] \"slow\"", "a list of texts"});
}

TEST(SceneKeys, DampingIsARatioAndARate) {
  expect_error(with("density_kg_per_m3 = 2500", "density_kg_per_m3 = 2500\ndamping_ratio = 5"), 12,
               {"damping_ratio in [material.concrete] is 5", "a number from 0 to 1"});
  expect_error(with("step_s = 0.01", "mass_damping_per_s = -1"), 5, {"mass_damping_per_s in [analysis] is -1"});
}

TEST(SceneKeys, TheReservoirIsAskedForByAFlag) {
  expect_error(with("frame_every_s = 0.5", "reservoir = 1"), 51, {"reservoir in [output] is 1", "true or false"});
}

}  // namespace
}  // namespace blockweir::scene_keys_test
