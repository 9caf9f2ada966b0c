// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// What a scene states and does not get is said: an error, or a warning where it may be meant.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_effects_test {
using namespace blockweir::scene;
using sample::expect_error;
using sample::expect_warning;
using sample::text;
using sample::warnings;
using sample::with;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

const std::string beside_the_crack = "[[joints]]\nname = \"foot\"\nbetween = [\"ground\", \"top\"]\n";

/// The sample with lines before its first [[support]], which stands in line 31.
std::string before_supports(const std::string& lines) {
  return with("[[support]]", lines + "[[support]]");
}
std::string at_the_end(const std::string& lines) {
  return text + lines;
}

TEST(SceneEffects, KeysOfWaterThatAnotherKeySwitchesOffAreToldAndNotWhereTheyAct) {
  for (const char* law : {"full", "triangular"}) {
    const std::string crest = std::string("[water]\ncrest_pressure = \"") + law + "\"\n";
    expect_warning(with("[water]", crest), 45,
                   {"crest_pressure in [water] has no effect in this scene", "expected may_overtop = true in [water]"});
    EXPECT_THAT(warnings(with("[water]", crest + "may_overtop = true\n")), IsEmpty());
  }
  EXPECT_THAT(warnings(with("[water]", "[water]\ncrest_pressure = \"none\"\n")), IsEmpty());
  for (const char* key : {"wets_ends = true", "skip_unchanged = false"}) {
    const std::string stated = with("[water]", std::string("[water]\n") + key + "\n");
    EXPECT_THAT(warnings(stated), IsEmpty());
    const auto said = warnings(with("\"hydrostatic\"", "\"openfoam\"", stated));
    EXPECT_THAT(said, testing::Contains(HasSubstr("in [water] has no effect in this scene; expected model"))) << key;
  }
}

/// Pressures of a window's end are neither held nor on a line.
TEST(SceneEffects, TheLoadInAWindowBesideSoundIsTold) {
  const std::string sound =
      with("model = \"hydrostatic\"", "model = \"reservoir\"\nreservoir = { compressible = true }");
  EXPECT_THAT(warnings(with("window_s = 0.02", "window_s = 0.01\nload_in_window = \"linear\"", sound)),
              testing::Contains(HasSubstr("load_in_window in [coupling] has no effect in this scene")));
}

TEST(SceneEffects, TheSampleHasNoWarning) {
  EXPECT_THAT(warnings(text), IsEmpty());
}

TEST(SceneEffects, AJointWithUpliftOrBondWhoseBlocksDoNotTouchIsAnErrorThatNamesThoseThatDo) {
  for (const char* law : {"uplift = \"full\"\n", "cohesion_pa = 1e5\n", "tension_strength_pa = 1e5\n"}) {
    expect_error(before_supports(beside_the_crack + law), 33,
                 {"blocks \"ground\" and \"top\" of [[joints]] \"foot\" do not touch (",
                  "m apart): its bond or uplift acts nowhere", "expected two blocks that touch along a line",
                  "\"ground\" touches \"base\", \"top\" touches \"base\""});
  }
}

TEST(SceneEffects, AJointOfBlocksThatMayMeetLaterIsAWarning) {
  expect_warning(before_supports(beside_the_crack + "friction_angle_deg = 20\n"), 33,
                 {"m apart): its law acts once they meet", "\"ground\" touches \"base\""});
}

TEST(SceneEffects, AJointOfFixedBlocksIsAnError) {
  expect_error(with("vertices_m = [[0, 0], [3, 0]", "fixed = true\nvertices_m = [[0, 0], [3, 0]",
                    with("between = [\"base\", \"top\"]", "between = [\"ground\", \"base\"]",
                         with("block = \"base\"\npoint_m = [0, 0]", "block = \"top\"\npoint_m = [0, 2]"))),
               30, {"[[joints]] \"crack\" has no effect: \"ground\" and \"base\" are both fixed"});
}

TEST(SceneEffects, ATensionStrengthWithoutCohesionIsToldToCountAsNone) {
  const ReadScene read = read_text(with("cohesion_pa = 1e5", "tension_strength_pa = 1e5"), "s.toml");
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_THAT(read.notes[0].text(),
              HasSubstr("tension_strength_pa is 100000, more than cohesion over tan(friction angle); "
                        "0 Pa is used instead"));
}

TEST(SceneEffects, ABondLongerThanItsJointIsAnError) {
  expect_error(with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nbonded_length_m = 3.5"), 31,
               {"bonded_length_m 3.5 in [[joints]] \"crack\" is longer than the joint, 3 m"});
}

TEST(SceneEffects, AKeyOfABondWithoutOneIsAnError) {
  expect_error(with("cohesion_pa = 1e5", "bonded_length_m = 1"), 30,
               {"bonded_length_m in [[joints]] \"crack\" has no effect: the joint has no bond"});
  expect_error(with("cohesion_pa = 1e5", "keeps_cohesion = true"), 30, {"keeps_cohesion", "the joint has no bond"});
  expect_error(with("cohesion_pa = 1e5", "softening_slip_m = 0.1"), 30,
               {"softening_slip_m", "the joint has no bond or residual friction"});
}

TEST(SceneEffects, AKeyOfABondThatIsStatedAsNothingIsAWarning) {
  expect_warning(with("cohesion_pa = 1e5", "cohesion_pa = 0\nbonded_length_m = 1"), 31,
                 {"bonded_length_m", "the joint has no bond", "expected a bond above 0"});
}

TEST(SceneEffects, ADilationLimitWithoutDilationIsAnError) {
  expect_error(with("cohesion_pa = 1e5", "cohesion_pa = 1e5\ndilation_limit_m = 0.1"), 31,
               {"dilation_limit_m", "the joint has no dilation_angle_deg"});
}

TEST(SceneEffects, KeysOfAllJointsMayWaitForOthersToCompleteThem) {
  EXPECT_THAT(warnings(with("friction_angle_deg = 30", "friction_angle_deg = 30\nbonded_length_m = 1")), IsEmpty());
  expect_error(with("friction_angle_deg = 30", "friction_angle_deg = 30\ndilation_limit_m = 1"), 14,
               {"dilation_limit_m in [joint] has no effect"});
}

TEST(SceneEffects, ABondOfNoLengthIsAWarning) {
  expect_warning(with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nbonded_length_m = 0"), 31,
                 {"cohesion and tension strength have no effect"});
}

TEST(SceneEffects, AResidualAngleAboveThePeakIsAWarning) {
  expect_warning(with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nresidual_friction_angle_deg = 60"), 31,
                 {"is above the peak", "exchange the two"});
}

TEST(SceneEffects, WhatFollowsTheFailureOfABondThatIsKeptIsAWarning) {
  expect_warning(with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nkeeps_cohesion = true\nsoftening_slip_m = 0.1"), 32,
                 {"softening_slip_m", "with keeps_cohesion the bond never fails"});
  expect_warning(
      with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nkeeps_cohesion = true\nresidual_friction_angle_deg = 20"), 32,
      {"residual_friction_angle_deg", "with keeps_cohesion the bond never fails"});
}

/// Without what follows [water].
std::string dry(const std::string& scene) {
  return scene.substr(0, scene.find("[water]"));
}

TEST(SceneEffects, UpliftWithoutWaterIsAnError) {
  expect_error(dry(with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nuplift = \"full\"")), 31,
               {"uplift in [[joints]] \"crack\" has no effect: the scene has no water", "add [water]"});
}

TEST(SceneEffects, UpliftWhereTheModelTakesTheWaterAwayIsAWarning) {
  expect_warning(with("model = \"hydrostatic\"", "model = \"none\"",
                      with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nuplift = \"full\"")),
                 31, {"uplift in [[joints]] \"crack\" has no effect", "takes no water into joints"});
}

TEST(SceneEffects, UpliftThatTheWaterNeverReachesIsAWarning) {
  expect_warning(
      with("{ table = [[0, 1], [2, 3]] }", "1.5", with("cohesion_pa = 1e5", "cohesion_pa = 1e5\nuplift = \"full\"")),
      31, {"the water stays below 1.5 m, the joint is above 2 m"});
}

TEST(SceneEffects, ALevelBelowAllThatCanMoveIsAWarning) {
  expect_warning(
      with("[fluid]", "downstream_level_m = -0.5\n[fluid]"), 46,
      {"downstream_level_m has no effect at the start: the level stays below -0.5 m", "leave downstream_level_m out"});
}

TEST(SceneEffects, LoadsSupportsAndBoltsOnFixedBlocksAreErrors) {
  expect_error(with("block = \"top\"\npoint_m = [0, 4]", "block = \"ground\"\npoint_m = [0, 0]"), 36,
               {"[[point_load]] has no effect: block \"ground\" is fixed"});
  expect_error(
      with("block = \"top\"\nfrom_m = [3, 2]\nto_m = [3, 4]", "block = \"ground\"\nfrom_m = [8, -1]\nto_m = [8, 0]"),
      40, {"[[face_pressure]] has no effect: block \"ground\" is fixed"});
  expect_error(with("block = \"base\"", "block = \"ground\""), 32,
               {"[[support]] has no effect: block \"ground\" is fixed"});
  expect_error(at_the_end("[[line_load]]\nblock = \"ground\"\nfrom_m = [8, -1]\nto_m = [8, 0]\nforce_x_n_per_m2 = 1\n"),
               57, {"[[line_load]] has no effect"});
  expect_error(at_the_end("[[body_load]]\nblocks = [\"top\", \"ground\"]\nacceleration_x_m_per_s2 = 1\n"), 57,
               {"[[body_load]] has no effect: block \"ground\" is fixed"});
  expect_error(at_the_end("[[bolt]]\nname = \"b\"\nfrom_block = \"ground\"\nfrom_m = [0, 0]\nto_m = [0, -1]\n"
                          "stiffness_n_per_m2 = 1\n"),
               58, {"[[bolt]] \"b\" has no effect: neither of its ends can move"});
}

const std::string all_fixed = R"([analysis]
duration_s = 1
[material.m]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[[block]]
name = "a"
material = "m"
fixed = true
vertices_m = [[0, 0], [1, 0], [1, 1], [0, 1]]
)";

TEST(SceneEffects, ABodyLoadWhereNothingCanMoveIsAnError) {
  expect_error(all_fixed + "[[body_load]]\nacceleration_x_m_per_s2 = 1\n", 12,
               {"[[body_load]] has no effect: no block can move"});
}

TEST(SceneEffects, ABodyLoadIsNotBlamedWhereTheBlocksThatItWouldMoveAreRefused) {
  const std::string wall =
      "[[wall]]\nname = \"w\"\nmaterial = \"m\"\nrows = 90000\ncolumns = 90000\n"
      "brick_length_m = 1\nbrick_height_m = 1\n";
  try {
    read_text(all_fixed + wall + "[[body_load]]\nacceleration_x_m_per_s2 = 1\n", "scene.toml");
    FAIL() << "no error";
  } catch (const SceneError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U) << error.what();
  }
}

TEST(SceneEffects, ASceneInWhichNothingCanHappenIsAWarning) {
  expect_warning(all_fixed, 0, {"nothing can happen: all blocks are fixed, and there is no water"});
}

TEST(SceneEffects, ASceneInWhichWaterPressesWhatCannotMoveIsAWarningUnlessItsLoadsAreAskedFor) {
  const std::string wet = all_fixed + "[water]\nupstream_level_m = 0.5\n";
  expect_warning(wet, 0, {"nothing can move: all blocks are fixed", "free the structure's blocks"});
  EXPECT_THAT(sample::warnings(wet + "[[expect]]\nquantity = \"water_force_x_n_per_m\"\nof = \"a\"\nvalue = 1\n"),
              testing::IsEmpty());
}

TEST(SceneEffects, ASceneWithoutBlocksIsAnError) {
  EXPECT_THAT(sample::errors("[analysis]\nduration_s = 1\n[material.m]\nyoungs_modulus_pa = 50e9\n"
                             "poissons_ratio = 0.2\ndensity_kg_per_m3 = 2500\n",
                             {"block=[]"}),
              ElementsAre(HasSubstr("the scene has no block")));
  EXPECT_THAT(sample::errors(all_fixed, {"block=[]"}), ElementsAre(HasSubstr("the scene has no block")));
}

TEST(SceneEffects, MotionOfAFixedBlockIsAnError) {
  expect_error(with("fixed = true", "fixed = true\ninitial_velocity_m_per_s = [1, 0]"), 18,
               {"block \"ground\" is fixed and has an initial_velocity_m_per_s"});
  expect_error(with("fixed = true", "fixed = true\ninitial_spin_deg_per_s = 3"), 18, {"initial_spin_deg_per_s"});
}

TEST(SceneEffects, KeysThatTheStateOfABlockSwitchesOffAreWarnings) {
  expect_warning(with("fixed = true", "fixed = true\nrigid = true"), 18,
                 {"rigid of block \"ground\" has no effect: the block is fixed"});
  expect_warning(with("fixed = true", "fixed = true\ninitial_stress_pa = [1, 0, 0]"), 18, {"initial_stress_pa"});
  const std::string top = "vertices_m = [[0, 2], [3, 2], [3, 4], [0, 4]]";
  expect_warning(with(top, "rigid = true\ninitial_stress_pa = [1, 0, 0]\n" + top), 27, {"the block is rigid"});
  expect_warning(with(top, "initial_velocity_m_per_s = [1, 0]\n" + top,
                      with("step_s = 0.01", "step_s = 0.01\nkind = \"quasi-static\"")),
                 27, {"velocities count in a dynamic analysis only"});
}

TEST(SceneEffects, KeysThatAnotherKeySwitchesOffAreWarnings) {
  const std::string analysis = "step_s = 0.01";
  expect_warning(with(analysis, analysis + "\nspectral_radius = 0.5"), 6,
                 {"spectral_radius in [analysis] has no effect", "expected integrator = \"generalized-alpha\""});
  expect_warning(with(analysis, analysis + "\nresidual_tolerance = 1e-6"), 6, {"residual_tolerance", "static"});
  expect_warning(with(analysis, analysis + "\nkind = \"quasi-static\"\nmass_damping_per_s = 1"), 7,
                 {"mass_damping_per_s"});
  expect_warning(with(analysis, analysis + "\ngravity_m_per_s2 = 0\ngravity_tilt_deg = 10", dry(text)), 7,
                 {"gravity_tilt_deg"});
  const std::string penalty = "formulation = \"penalty\"\n";
  expect_warning(with("max_iterations = 100", penalty + "initial_penalty_n_per_m2 = 1e9"), 8,
                 {"initial_penalty_n_per_m2"});
  expect_warning(with("max_iterations = 100", penalty + "penetration_tolerance_m = 1e-9"), 8,
                 {"penetration_tolerance_m"});
  expect_warning(with("[water]", "[water]\natmospheric_pressure_pa = 101300"), 45, {"atmosphere = \"wet-faces\""});
  expect_warning(with("frame_every_s = 0.5", "reservoir = true", with("\"hydrostatic\"", "\"none\"")), 51,
                 {"reservoir in [output] has no effect"});
  expect_warning(with("\"hydrostatic\"", "\"openfoam\"", with("[water]", "[water]\nopen_crack_width_m = 0.1")), 45,
                 {"open_crack_width_m in [water] has no effect"});
}

TEST(SceneEffects, CouplingWithoutWaterIsAWarning) {
  expect_warning(dry(text) + "[coupling]\nwindow_s = 0.02\n", 44, {"[coupling] has no effect: the scene has no water"});
}

TEST(SceneEffects, AMaterialOfNoBlockIsAWarning) {
  expect_warning(
      at_the_end("[material.spare]\nyoungs_modulus_pa = 50e9\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2500\n"), 56,
      {"[material.spare] has no effect: no block is of it"});
}

TEST(SceneEffects, GroundThatShakesUnderStillWaterIsAWarning) {
  const std::string shaken = "[base_motion]\nacceleration_x_m_per_s2 = ";
  expect_warning(before_supports(shaken + "{ sine = 1, frequency_hz = 2 }\n"), 31,
                 {"still water has no inertia", "model = \"openfoam\""});
  EXPECT_THAT(warnings(with("model = \"hydrostatic\"", "model = \"openfoam\"")), IsEmpty());
}

TEST(SceneEffects, ARecordThatEndsInTheMidstOfTheRunIsAWarning) {
  const auto shaken = [](const std::string& rows) {
    return before_supports("[base_motion]\nacceleration_x_m_per_s2 = { table = " + rows + " }\n");
  };
  EXPECT_THAT(warnings(shaken("[[0, 0], [1, 0.2]]")),
              testing::Contains(
                  HasSubstr("s.toml:32: warning: acceleration_x_m_per_s2 ends at 1 s with 0.2 m/s2, which then acts "
                            "to the end of the run, 2 s; expected a last value of 0")));
  for (const char* rows : {"[[0, 0], [1, 0]]", "[[0, 0], [2, 0.2]]"}) {
    EXPECT_THAT(warnings(shaken(rows)), ElementsAre(HasSubstr("still water"))) << rows;
  }
}

}  // namespace
}  // namespace blockweir::scene_effects_test
