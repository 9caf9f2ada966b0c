// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Time tables in their four forms, and water levels that do not suit the model.
#include <gtest/gtest.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_water_test {
using namespace blockweir::scene;
using sample::errors;
using sample::expect_error;
using sample::text;
using sample::with;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

constexpr const char* level = "upstream_level_m = { table = [[0, 1], [2, 3]] }";

TimeTable level_of(const std::string& value) {
  return *read_text(with(level, "upstream_level_m = " + value), "s.toml").scene.water.upstream_level_m;
}

TEST(SceneWater, LumpedForcesNeedManyElementsAndConsistentOnesOneAndWhatIsStatedHolds) {
  const auto elements = [](const std::string& more) {
    return read_text(with("[water]", "[water]\n" + more), "s.toml").scene.water.elements_per_face;
  };
  EXPECT_EQ(elements(""), 1);
  EXPECT_EQ(elements("nodal_rule = \"lumped\""), 20);
  EXPECT_EQ(elements("elements_per_face = 7"), 7);
}

TEST(SceneTimeTable, ANumberIsConstant) {
  const TimeTable t = level_of("3");
  EXPECT_EQ(t.at(-1), 3);
  EXPECT_EQ(t.at(100), 3);
}

TEST(SceneTimeTable, ATableIsLinearAndHeldOutside) {
  const TimeTable t = level_of("{ table = [[0.5, 1], [1.5, 3]] }");
  EXPECT_EQ(t.at(0), 1);
  EXPECT_EQ(t.at(0.75), 1.5);
  EXPECT_EQ(t.at(1.5), 3);
  EXPECT_EQ(t.at(9), 3);
}

TEST(SceneTimeTable, StepsHoldUntilTheNextRow) {
  const TimeTable t = level_of("{ steps = [[0, 1], [1, 3]] }");
  EXPECT_EQ(t.at(0.999), 1);
  EXPECT_EQ(t.at(1), 3);
  EXPECT_EQ(t.at(5), 3);
}

TEST(SceneTimeTable, ARampReachesTheEndOfTheRun) {
  const TimeTable t = level_of("{ from = 1, rate_per_s = 0.5 }");
  EXPECT_THAT(t.time_s, ElementsAre(0, 2));
  EXPECT_THAT(t.value, ElementsAre(1, 2));
}

TEST(SceneTimeTable, ARampStopsAtItsEnd) {
  const TimeTable t = level_of("{ from = 3, rate_per_s = -4, to = 1 }");
  EXPECT_THAT(t.time_s, ElementsAre(0, 0.5));
  EXPECT_EQ(t.at(0.25), 2);
  EXPECT_EQ(t.at(2), 1);
}

TEST(SceneTimeTable, FaultsNameTheirLine) {
  const auto fault = [](const std::string& value, int line, const std::vector<std::string>& words) {
    expect_error(with(level, "upstream_level_m = " + value), line, words);
  };
  fault("{ table = [[0, 1],\n[1, 2],\n[1, 3]] }", 47, {"goes from time 1 s to 1 s", "times that increase"});
  fault("{ table = [[1, 1], [0, 2]] }", 45, {"table in upstream_level_m of [water] goes from time 1 s to 0 s"});
  fault("{ table = [] }", 45, {"rows [[time_s, value], ...]"});
  fault("{ table = [[0, 1],\n[1]] }", 46, {"a row [time_s, value] of two finite numbers"});
  fault("{ steps = [[0, inf]] }", 45, {"steps in upstream_level_m of [water]"});
  fault("{ tabel = [[0, 1]], from = 1, rate_per_s = 0 }", 45, {"unknown key \"tabel\"", "did you mean \"table\"?"});
  fault("{ table = [[0, 1]], steps = [[0, 1]] }", 45, {"does not state one course in time", "keep one of"});
  fault("{ }", 45, {"does not state one course in time"});
  fault("{ from = 1 }", 45, {"has no \"rate_per_s\""});
  fault("{ from = 1, rate_per_s = -1, to = 3 }", 45, {"never gets from 1 to 3 at -1 per second"});
  fault("{ from = 1, rate_per_s = 0, to = 3 }", 45, {"never gets from 1 to 3"});
  fault("{ from = 1, rate_per_s = 1e308 }", 45, {"never gets from 1 to inf"});
  fault("\"high\"", 45, {"upstream_level_m in [water] is 'high'", "{ table = [[time_s, value], ...] }"});
  fault("nan", 45, {"upstream_level_m in [water] is nan"});
}

TEST(SceneWater, WhetherTheEndsStandInWaterIsLeftOpenOrStated) {
  const auto read = [](const std::string& key) {
    return read_text(with("[water]", "[water]\n" + key), "s.toml").scene.water.wets_ends;
  };
  EXPECT_EQ(read(""), std::nullopt);
  EXPECT_EQ(read("wets_ends = true"), true);
  EXPECT_EQ(read("wets_ends = false"), false);
  expect_error(with("[water]", "[water]\nwets_ends = 1"), 45, {"wets_ends", "true or false"});
}

TEST(SceneWater, ALevelAboveTheStructureIsRefusedUnlessMeant) {
  const std::string high = with("[2, 3]", "[2, 4.5]");
  expect_error(high, 45, {"upstream_level_m reaches 4.5 m, above the structure's top at 4 m", "may_overtop"});
  EXPECT_THAT(errors(with("[water]", "[water]\nmay_overtop = true", high)), IsEmpty());
  expect_error(with("[water]", "[water]\ndownstream_level_m = 5"), 45, {"downstream_level_m reaches 5 m"});
}

/// 3.1 + 9 * 0.1 is 4.000000000000001.
TEST(SceneWater, ALevelAtTheCrestIsNotAboveItByRoundOff) {
  EXPECT_THAT(errors(with("[2, 3]", "[2, 4.000000000001]")), IsEmpty());
}

TEST(SceneWater, ALevelBetweenTheRowsOrAfterTheRunIsJudgedByTheTimeOfTheRun) {
  EXPECT_THAT(errors(with("[2, 3]", "[4, 7]")), IsEmpty());
  expect_error(with("[2, 3]", "[4, 7.1]"), 45, {"reaches 4.05 m"});
  expect_error(with("{ table = [[0, 1], [2, 3]] }", "{ steps = [[0, 1], [1, 9], [1.1, 1]] }"), 45, {"reaches 9 m"});
}

TEST(SceneWater, ALevelBelowTheModelIsRefused) {
  expect_error(with("[0, 1]", "[0, -1.5]"), 45,
               {"upstream_level_m falls to -1.5 m, below the model's lowest vertex at -1"});
}

TEST(SceneWater, WaterWithoutALevelIsRefused) {
  expect_error(with(level, ""), 44, {"[water] has no level", "leave [water] out"});
}

TEST(SceneWater, UnderTiltedGravityIsRefused) {
  expect_error(with("[analysis]", "[analysis]\ngravity_tilt_deg = 5"), 45,
               {"[water] in a scene whose gravity is tilted", "turn the blocks instead"});
}

TEST(SceneWater, AColumnStandsOnAnEdgeAndHasNoPool) {
  const auto column = [](const std::string& at, const std::string& level_of_sample) {
    return with("\"hydrostatic\"", "\"column\"\n[fluid.column]\nblock = \"base\"\nlength_m = 2\nat_m = " + at,
                with(level, level_of_sample));
  };
  EXPECT_THAT(errors(column("[0, 1]", "")), IsEmpty());
  expect_error(column("[0, 1]", level), 48, {"a level in [water], but a column has no pool", "leave the level out"});
  expect_error(column("[0.5, 1]", ""), 51, {"(0.5, 1) is not on the outline of block \"base\"", "move the point"});
}

TEST(SceneWater, DrawnWaterIsAListOfOutlines) {
  const auto drawn = [](const std::string& value) {
    return with("\"hydrostatic\"", "\"openfoam\"\ninitial_water_m = " + value);
  };
  expect_error(drawn("3"), 48, {"initial_water_m in [fluid] is 3", "a list of outlines [[[x, y], ...], ...]"});
  expect_error(drawn("[[[0, 0], [1, 1]]]"), 48, {"a list of 3 to 10000 points"});
}

TEST(SceneWater, AFluidWithoutWaterIsRefused) {
  expect_error(with(std::string("[water]\n") + level, ""), 46, {"a fluid, but no [water]"});
}

TEST(SceneWater, TheFluidIsHydrostaticWhereThereIsWaterUnlessTheSceneSaysNone) {
  EXPECT_EQ(read_text(with("[fluid]\nmodel = \"hydrostatic\"\n", ""), "s").scene.fluid, FluidModel::hydrostatic);
  EXPECT_EQ(read_text(with("model = \"hydrostatic\"", "model = \"none\""), "s").scene.fluid, FluidModel::none);
}

TEST(SceneWater, ACaseOfOnesOwnIsNamedInPlaceOfTheKeysThatWriteOne) {
  const Scene own = read_text(with("\"hydrostatic\"", "\"openfoam\"\ncase = \"mine\""), "s.toml").scene;
  EXPECT_EQ(own.openfoam.own_case, "mine");
  EXPECT_EQ(own.openfoam.level_control, LevelControl::free);
  const auto refused = [](const std::string& keys, const std::vector<std::string>& words) {
    expect_error(with("\"hydrostatic\"", "\"openfoam\"\ncase = \"mine\"\n" + keys), 49, words);
  };
  for (const char* key : {"cells_in_depth = 20", "upstream_depths = 2", "downstream_depths = 2", "freeboard_depths = 1",
                          "floor_m = 0", "air_density_kg_per_m3 = 1.2", "initial_water_m = [[[0, 0], [1, 0], [0, 1]]]",
                          "wave = { kind = \"solitary\", height_m = 0.1 }"}) {
    refused(key, {" beside case", "a case of your own has its mesh, its air and its water", "or case"});
  }
  expect_error(with("\"hydrostatic\"", "\"openfoam\"\ncase = \"\""), 48, {"case names no folder"});
  expect_error(with("\"hydrostatic\"", "\"hydrostatic\"\ncase = \"mine\""), 48, {"case without OpenFOAM"});
}

TEST(SceneWater, DrawnWaterIsTakenCounterClockwiseAndHasToBeSound) {
  const auto drawn = [](const std::string& outlines) {
    return with("\"hydrostatic\"", "\"openfoam\"\ninitial_water_m = " + outlines);
  };
  const ReadScene turned = read_text(drawn("[[[-3, 0], [-3, 1], [-2, 1], [-2, 0]]]"), "s.toml");
  EXPECT_THAT(turned.scene.openfoam.initial_water_m,
              ElementsAre(ElementsAre(Point(-3, 0), Point(-2, 0), Point(-2, 1), Point(-3, 1))));
  ASSERT_EQ(turned.notes.size(), 1U);
  EXPECT_THAT(turned.notes[0].text(), testing::HasSubstr("outline 1 of initial_water_m runs clockwise"));
  expect_error(drawn("[\n[[-3, 0], [-2, 0], [-2, 1]],\n[[-3, 2], [-2, 3], [-2, 2], [-3, 3]]]"), 50,
               {"outline 2 of initial_water_m crosses itself at (-2.5, 2.5)", "put the vertices in order"});
}

TEST(SceneWater, ResultsOfOneProcessAreNotPutTogether) {
  expect_error(with("\"hydrostatic\"", "\"openfoam\"\nreconstruct = true"), 48, {"reconstruct with one process"});
  EXPECT_TRUE(read_text(with("\"hydrostatic\"", "\"openfoam\"\nprocesses = 2\nreconstruct = true"), "s.toml")
                  .scene.openfoam.reconstruct);
}

TEST(SceneWater, TolerancesOfOpenFoamAreSmallAndRestIsForWaterThatNothingElseMoves) {
  const auto openfoam = [](const std::string& keys) { return with("\"hydrostatic\"", "\"openfoam\"\n" + keys); };
  EXPECT_EQ(read_text(openfoam("move_tolerance = 0\nrest_tolerance = 1e-5"), "s.toml").scene.openfoam.rest_tolerance,
            1e-5);
  for (const std::string key : {"move_tolerance", "rest_tolerance"}) {
    expect_error(openfoam(key + " = 0.01"), 48, {key + " in [fluid] is 0.01", "a number from 0 to 0.001"});
    expect_error(openfoam(key + " = -1e-9"), 48, {"a number from 0 to 0.001"});
    expect_error(with("\"hydrostatic\"", "\"hydrostatic\"\n" + key + " = 0"), 48, {key + " without OpenFOAM"});
  }
  const std::vector<std::string> moved{"rest_tolerance beside a base motion, regular waves or a case of your own",
                                       "leave rest_tolerance out"};
  expect_error(openfoam("rest_tolerance = 1e-5\ncase = \"mine\""), 48, moved);
  expect_error(openfoam("rest_tolerance = 1e-5\n"
                        "wave = { kind = \"regular\", height_m = 0.1, period_s = 1 }"),
               48, moved);
  expect_error(openfoam("rest_tolerance = 1e-5") + "\n[base_motion]\nacceleration_x_m_per_s2 = 1\n", 48, moved);
}

}  // namespace
}  // namespace blockweir::scene_water_test
