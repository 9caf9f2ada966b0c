// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// What pictures of a section show of loads, bolts and water.
#include "bridge/picture/section_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "bridge/picture/force_text.hpp"
#include "bridge/picture/frames.hpp"
#include "bridge/scene/read/read.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::picture::section_state_test {
namespace {

using nlohmann::json;

/// Pressures of every kind on the sample's base, and some on the ground.
const json water = json::parse(R"J([
  {"name": "open water", "panels": [[0, 2, 0, 0, 0, 20000, 1], [3, 0, 3, 1, 10000, 0, 1], [-5, 0, 0, 0, 9, 9, 0]]},
  {"name": "ice", "panels": [[0, 2, 0, 1.5, 1000, 1000, 1]]},
  {"name": "added water (Westergaard)", "panels": [[0, 2, 0, 1, 0, 500, 1], [0, 1, 0, 0, 500, 900, 1]]},
  {"name": "water in joints", "panels": [[0, 0, 3, 0, 20000, 0, 1], [3, 0, 0, 0, 0, 20000, 0]]}])J");

const std::string more = R"(
[[line_load]]
block = "top"
from_m = [0, 4]
to_m = [0, 3]
force_x_n_per_m2 = 10
[silt]
level_m = 1
submerged_density_kg_per_m3 = 900
pressure_coefficient = 0.5
[earthquake]
horizontal_coefficient = 0.1
added_water_pressure = "none"
[[bolt]]
name = "anchor"
from_block = "top"
to_block = "ground"
from_m = [1, 4]
to_m = [1, -1]
stiffness_n_per_m2 = 1e7
prestress_n_per_m = 5e4
)";

json state_of(const json& forces = json::array()) {
  return section_state(scene::read_text(scene::sample::text + more, "s.toml").scene, water, 0, forces);
}

const json& load(const json& state, const std::string& name) {
  for (const json& one : state["acting"]) {
    if (one["name"] == name) return one;
  }
  throw std::runtime_error("no load " + name);
}

TEST(SectionState, HasTheResultantOfEveryKindOfLoad) {
  const json state = state_of();
  const auto force = [&](const char* name, std::size_t axis) { return load(state, name)["force"][axis].get<double>(); };
  EXPECT_NEAR(force("weight", 1), -2500 * 9.81 * 12, 1e-6);
  EXPECT_NEAR(force("inertia (earthquake)", 0), 0.1 * 2500 * 9.81 * 12, 1e-6);
  EXPECT_EQ(load(state, "point load")["force"], json::parse("[100.0, -200.0]"));
  EXPECT_NEAR(force("line load", 0), 10, 1e-12);
  EXPECT_LT(force("face pressure", 0), 0) << "a pressure on the downstream face acts upstream";
  EXPECT_NEAR(force("silt", 0), 0.5 * 900 * 9.81 / 2, 1e-9);
  EXPECT_NEAR(force("water upstream", 0), 20000, 1e-9);
  EXPECT_NEAR(force("water downstream", 0), -5000, 1e-9);
  EXPECT_NEAR(force("ice", 0), 500, 1e-9);
  EXPECT_NEAR(force("added water (Westergaard)", 0), 950, 1e-9);
  EXPECT_NEAR(force("uplift in base on ground", 1), 30000, 1e-9);
  EXPECT_EQ(state["acting"].size(), 11U) << "what presses on the ground loads no block: " << state["acting"].dump();
}

TEST(SectionState, ResultantsLieWhereTheyAct) {
  const json state = state_of();
  EXPECT_NEAR(load(state, "water upstream")["arrow"][1][1].get<double>(), 2.0 / 3, 1e-12);
  EXPECT_NEAR(load(state, "silt")["arrow"][1][1].get<double>(), 1.0 / 3, 1e-12);
  EXPECT_NEAR(load(state, "uplift in base on ground")["at"][0].get<double>(), 1, 1e-12);
}

TEST(SectionState, KindsHaveColoursOfTheirOwnAndStandAtTheFaceThatTheyPressOn) {
  const json state = state_of();
  std::set<std::string> colours;
  for (const char* name : {"water upstream", "silt", "ice", "added water (Westergaard)", "uplift in base on ground"}) {
    EXPECT_TRUE(colours.insert(load(state, name)["colour"]).second) << name;
  }
  for (const char* name : {"water upstream", "silt", "ice", "added water (Westergaard)"}) {
    double right = -1e300;
    for (const json& outline : load(state, name)["diagrams"]) {
      for (const json& p : outline) right = std::max(right, p[0].get<double>());
    }
    EXPECT_EQ(right, 0) << name;
  }
}

/// The nappe's weight is told apart from what presses on the face, wherever the crest lies.
TEST(SectionState, WaterOnTheCrestHasALabelOfItsOwn) {
  json over = water;
  over[0]["panels"].push_back({3, 4, 0, 4, 5000, 15000, 2});
  const scene::Scene scene = scene::read_text(scene::sample::text + more, "s.toml").scene;
  const json state = section_state(scene, over, 0, json::array());
  EXPECT_NEAR(load(state, "water on the crest")["force"][1].get<double>(), -30000, 1e-9);
  EXPECT_NEAR(load(state, "water upstream")["force"][0].get<double>(), 20000, 1e-9);
  EXPECT_NEAR(load(state, "water upstream")["force"][1].get<double>(), 0, 1e-9);
  EXPECT_EQ(load(state, "water on the crest")["label"], "water on the crest 30 kN/m");
  const auto in_legend = [&](const json& row) { return row["label"] == "water on the crest 30 kN/m"; };
  EXPECT_TRUE(std::any_of(state["legend"].begin(), state["legend"].end(), in_legend)) << state["legend"].dump();
}

/// Beyond the toe, on rock that can move: flat, rising away from the dam, and a sill that looks upstream.
TEST(SectionState, TailwaterOnRockBeyondTheToeIsWaterDownstream) {
  json beyond = water;
  for (const json& panel :
       {json{5, 0, 3, 0, 10000, 10000, 1}, json{7, 0.5, 5, 0, 5000, 10000, 1}, json{7, 1, 7, 0.5, 0, 5000, 1}}) {
    beyond[0]["panels"].push_back(panel);
  }
  const scene::Scene scene = scene::read_text(scene::sample::text + more, "s.toml").scene;
  const json state = section_state(scene, beyond, 0, json::array());
  EXPECT_NEAR(load(state, "water upstream")["force"][0].get<double>(), 20000, 1e-9);
  EXPECT_NEAR(load(state, "water upstream")["force"][1].get<double>(), 0, 1e-9);
  EXPECT_NEAR(load(state, "water downstream")["force"][1].get<double>(), -20000 - 15000, 1e-9);
}

/// The upstream face of a crest that leans far over it looks down.
TEST(SectionState, WaterUnderAnOverhangIsThatOfThePoolInFrontOfIt) {
  json under = water;
  under[0]["panels"] = {{2, 3, 2.5, 2, 10000, 20000, 1}};
  const scene::Scene scene = scene::read_text(scene::sample::text + more, "s.toml").scene;
  const json state = section_state(scene, under, 0, json::array());
  EXPECT_NEAR(load(state, "water upstream")["force"][0].get<double>(), 15000, 1e-9);
}

/// Of a joint with a step between two blocks that can move, the upper block has all that presses it.
TEST(SectionState, UpliftHasTheUprightLegOfABentJoint) {
  json bent = water;
  bent[3]["panels"] = json::parse(R"J([[0, 1, 2, 1, 5000, 5000, 2], [2, 1, 2, 2, 5000, 4000, 2],
    [2, 2, 3, 2, 4000, 4000, 2], [2, 1, 0, 1, 5000, 5000, 1], [2, 2, 2, 1, 4000, 5000, 1], [3, 2, 2, 2, 4000, 4000, 1],
    [3, 0, 3, 1, 900, 900, 0], [3, 1, 3, 0, 900, 900, 1]])J");
  const scene::Scene scene = scene::read_text(scene::sample::text + more, "s.toml").scene;
  const json state = section_state(scene, bent, 0, json::array());
  json force = {0, 0};
  for (const json& one : state["acting"]) {
    if (one["kind"] != "uplift") continue;
    for (const int axis : {0, 1}) force[axis] = force[axis].get<double>() + one["force"][axis].get<double>();
  }
  EXPECT_NEAR(force[1].get<double>(), 10000 + 4000, 1e-9);
  EXPECT_NEAR(force[0].get<double>(), -4500 + 900, 1e-9) << "the step, and a face against the ground";
}

/// An earthquake takes from the tailwater's pressure: that pulls, on a face that looks downstream.
TEST(SectionState, AddedWaterOfTheTailwaterStandsDownstream) {
  json both = water;
  both[2]["panels"].push_back({3, 0, 3, 1, -700, -100, 1});
  const json state =
      section_state(scene::read_text(scene::sample::text + more, "s.toml").scene, both, 0, json::array());
  const json& pulls = load(state, "added water (Westergaard) downstream");
  EXPECT_NEAR(pulls["force"][0].get<double>(), 400, 1e-9);
  for (const json& outline : pulls["diagrams"]) {
    for (const json& p : outline) EXPECT_GE(p[0].get<double>(), 3);
  }
  EXPECT_GT(pulls["arrow"][1][0].get<double>(), pulls["arrow"][0][0].get<double>());
  EXPECT_NEAR(load(state, "added water (Westergaard) upstream")["force"][0].get<double>(), 950, 1e-9);
}

TEST(SectionState, TheLegendHasLoadsWithTheirSizesAndBolts) {
  const json state = state_of();
  std::vector<std::string> labels;
  for (const json& row : state["legend"]) labels.push_back(row["label"]);
  EXPECT_THAT(labels, testing::IsSupersetOf({"water upstream 20 kN/m", "ice 0.5 kN/m",
                                             "uplift in base on ground 30 kN/m", "anchor 50 kN/m"}));
  EXPECT_EQ(state_of({6e4})["bolts"][0]["label"], "anchor 60 kN/m") << "the force that it has now";
}

TEST(SectionState, TheViewHasAllThatIsDrawn) {
  const json state = state_of();
  const json& view = state["view"];
  for (const json& one : state["acting"]) {
    for (const json& outline : one["diagrams"]) {
      for (const json& p : outline) {
        EXPECT_TRUE(p[0] > view["left"] && p[0] < view["right"] && p[1] > view["bottom"] && p[1] < view["top"]);
      }
    }
  }
}

/// Rock of 200 m that can move, too: the picture is of the dam of 8 m and 10 m, and what lies far away is cut off.
TEST(SectionState, TheViewIsThatOfTheDamOnWideRock) {
  const scene::Scene scene = scene::read_text(R"(analysis = { duration_s = 1 }
joint = { friction_angle_deg = 30, uplift = "triangular" }
material.stone = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[water]
upstream_level_m = 9
[[block]]
name = "deep"
material = "stone"
fixed = true
vertices_m = [[-100, -20], [100, -20], [100, -10], [-100, -10]]
[[block]]
name = "rock"
material = "stone"
vertices_m = [[-100, -10], [100, -10], [100, 0], [-100, 0]]
[[block]]
name = "dam"
material = "stone"
vertices_m = [[0, 0], [8, 0], [3, 10], [0, 10]]
[[joints]]
name = "bedding"
between = ["deep", "rock"]
)",
                                              "wide")
                                 .scene;
  const json pressures = json::parse(R"J([{"name": "water in joints", "panels": [
    [0, 0, 8, 0, 80000, 0, 2], [-100, -10, 100, -10, 80000, 90000, 1]]}])J");
  const json state = section_state(scene, pressures, 0, json::array());
  const double wide = state["view"]["right"].get<double>() - state["view"]["left"].get<double>();
  EXPECT_LT(wide, 3 * 10) << state["view"].dump();
  EXPECT_LT(state["view"]["top"].get<double>(), 15);
  EXPECT_NEAR(load(state, "uplift under dam")["force"][1].get<double>(), 320000, 1e-6);
  EXPECT_NEAR(load(state, "uplift in bedding")["force"][1].get<double>(), 17e6, 1e-3);
  EXPECT_EQ(load(state, "uplift under dam")["in_view"], true);
  EXPECT_EQ(load(state, "weight")["in_view"], load(state, "weight")["arrow"][1][0].get<double>() < 20);
}

/// On both faces of an upright joint the water presses alike: what it does to the block downstream is listed, by the
/// name that the tables have.
TEST(SectionState, UprightJointsAndJointsWithoutANameHaveTheirUplift) {
  const scene::Scene scene = scene::read_text(R"(
material.stone = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }
analysis.duration_s = 1
[[block]]
name = "rock"
material = "stone"
fixed = true
vertices_m = [[-9, -2], [9, -2], [9, 0], [-9, 0]]
[[block]]
name = "slab"
material = "stone"
vertices_m = [[0, 0], [2, 0], [2, 1], [0, 1]]
[[block]]
name = "apron"
material = "stone"
vertices_m = [[2, 0], [5, 0], [5, 1], [2, 1]]
[[joints]]
name = "steep"
between = ["slab", "apron"]
)",
                                              "upright")
                                 .scene;
  const json pressures = json::parse(R"J([{"name": "water in joints", "panels": [
    [2, 0, 2, 1, 9000, 3000, 1], [2, 1, 2, 0, 3000, 9000, 2], [0, 0, 2, 0, 9000, 9000, 1], [2, 0, 0, 0, 9000, 9000, 0]
    ]}])J");
  const json state = section_state(scene, pressures, 0, json::array());
  EXPECT_NEAR(load(state, "uplift in steep")["force"][0].get<double>(), 6000, 1e-9);
  EXPECT_NEAR(load(state, "uplift in slab on rock")["force"][1].get<double>(), 18000, 1e-9);
}

TEST(SectionState, LargeForcesAreInMeganewtons) {
  EXPECT_EQ(force_text(412.5e3), "412.5 kN/m");
  EXPECT_EQ(force_text(9999e3), "9999 kN/m");
  EXPECT_EQ(force_text(12.73e6), "12.73 MN/m");
}

/// Of a run's pictures, too: an anchor ends deep in the ground.
TEST(SectionState, AnchorsEndWithinTheFrame) {
  json frame = json::parse(R"({"blocks": [{"fixed": false, "outline": [[0, 0], [2, 0], [2, 4], [0, 4]]}],
                               "upstream_level_m": null, "downstream_level_m": null})");
  EXPECT_GT(view_of({frame}, 1e300).bottom, -1);
  frame["bolts"] = {{1, 4, 1, -9, 5e4}};
  EXPECT_LT(view_of({frame}, -1e300).bottom, -9);
}

}  // namespace
}  // namespace blockweir::picture::section_state_test
