// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Maps of stability with the real programs: cells that are right, refused and wrong are told apart.
#include "tests/block_on_plane.hpp"
#include "tests/processes.hpp"

namespace blockweir::test::stress_test {
namespace {

using testing::HasSubstr;

class Stress : public Processes {
 protected:
  /// A block that slides down a slope.
  void write_scene(const std::string& map) const {
    std::ofstream(folder / "s.toml") << R"([analysis]
duration_s = 0.1
step_s = 0.01
max_displacement_ratio = 1
gravity_tilt_deg = 30
[joint]
friction_angle_deg = 20
[[joints]]
name = "base"
between = ["plane", "block"]
)" << block_on_plane << map;
  }
  [[nodiscard]] int stress(const std::string& more = "") const {
    return shell(programs + "/blockweir stress s.toml --out s" + more);
  }
  [[nodiscard]] nlohmann::json rows() const { return nlohmann::json::parse(text("s/stress.json")); }
  /// Verdicts from the lowest row up, of the first map.
  [[nodiscard]] std::vector<std::string> verdicts() const {
    std::vector<std::string> all;
    const nlohmann::json table = rows();
    for (const auto& cell : table[0]["runs"]) all.push_back(cell["verdict"]);
    return all;
  }

  const std::string slide =
      "[[map]]\nname = 'slide'\nquantity = 'displacement_m'\nof = 'base'\nformula = 'incline-displacement'\n"
      "tolerance = 1e-6\n";
  const std::string penalty_and_step =
      "x_key = 'contact.initial_penalty_n_per_m2'\nx_values = [1e4, 1e8, 1e12]\ny_key = 'analysis.step_s'\n"
      "y_values = [0.001, 0.01]\n";
};

TEST_F(Stress, RightCellsAreDrawnAndCounted) {
  write_scene(slide + penalty_and_step);
  ASSERT_EQ(stress(), 0) << text("out");
  EXPECT_THAT(verdicts(), testing::Each("right"));
  EXPECT_EQ(rows()[0]["right"], 6);
  EXPECT_GT(rows()[0]["runs"][0]["iterations"], 0);
  EXPECT_THAT(text("out"), HasSubstr(" iterations, "));
  EXPECT_GT(fs::file_size(folder / "s/s/slide.png"), 1000U);
  EXPECT_THAT(text("out"), HasSubstr("1 map, no cell is wrong"));
}

/// Water of finite elements, up to 45 times as heavy as the wall that it presses on, on all schedules.
TEST_F(Stress, AWallOnASpringHasItsPeriodInAReservoir) {
  ASSERT_EQ(shell(programs + "/blockweir stress reservoir --short --out s"), 0) << text("out");
  for (const auto& map : rows()) EXPECT_EQ(map["right"], 9) << map["map"];
}

TEST_F(Stress, ACellThatIsOffIsWrong) {
  write_scene("[[map]]\nname = 'slide'\nquantity = 'displacement_m'\nof = 'base'\nvalue = 0.01\n" + penalty_and_step);
  EXPECT_EQ(stress(), 1);
  EXPECT_THAT(verdicts(), testing::Each("wrong"));
  EXPECT_THAT(text("out"), HasSubstr("cells are WRONG"));
  EXPECT_THAT(text("out"), HasSubstr("wrong: contact.initial_penalty_n_per_m2=10000, analysis.step_s=0.001: 0.00906"));
}

TEST_F(Stress, ACellIsRefusedWithItsReasonWhereTheMapSaysThatItMayBe) {
  const std::string ratios =
      "x_key = 'analysis.step_s'\nx_values = [0.01]\ny_key = 'material.rock.poissons_ratio'\ny_values = [0.2, 0.7]\n";
  write_scene(slide + ratios + "may_refuse = 1\n");
  ASSERT_EQ(stress(), 0) << text("out");
  EXPECT_THAT(verdicts(), testing::ElementsAre("refused", "right"));
  EXPECT_THAT(rows()[0]["runs"][0]["reason"].get<std::string>(), HasSubstr("poissons_ratio"));
  write_scene(slide + ratios);  // and is a mistake where it does not
  EXPECT_EQ(stress(), 2);
  EXPECT_THAT(text("out"), HasSubstr("poissons_ratio"));
}

TEST_F(Stress, AMapOfRefusalsAloneIsWrong) {
  write_scene(slide +
              "x_key = 'analysis.step_s'\nx_values = [0.01]\ny_key = 'material.rock.poissons_ratio'\ny_values = [0.7, "
              "0.8]\nmay_refuse = 2\n");
  EXPECT_EQ(stress(), 1);
  EXPECT_THAT(text("out"), HasSubstr("OUT wrong of 2 cells: expected 0, got 2"));
}

TEST_F(Stress, ACellThatHangsIsWrong) {
  write_scene(slide +
              "longest_s = 0.2\nx_key = 'analysis.step_s'\nx_values = [1e-7]\ny_key = 'analysis.rigid'\n"
              "y_values = ['none']\n");
  EXPECT_EQ(stress(), 1);
  EXPECT_THAT(text("out"), HasSubstr("still running when its time was over"));
  EXPECT_FALSE(orphan());
}

TEST_F(Stress, AShortMapHasTheEndsAndTheMiddleOfEachKey) {
  write_scene(slide +
              "x_key = 'contact.initial_penalty_n_per_m2'\nx_values = [1e4, 1e6, 1e8, 1e10, 1e12]\n"
              "y_key = 'analysis.step_s'\ny_values = [0.01]\n");
  ASSERT_EQ(stress(" --short"), 0) << text("out");
  ASSERT_EQ(rows()[0]["runs"].size(), 3U);
  EXPECT_EQ(rows()[0]["runs"][1]["x"], 1e8);
}

TEST_F(Stress, MapsOfTheCasesHaveNoWrongCellInShort) {
  EXPECT_EQ(shell(programs + "/blockweir stress --short cohesion penalty ratios sliver --out s"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("11 maps, no cell is wrong"));
  const nlohmann::json table = rows();
  for (const auto& row : table) EXPECT_EQ(row["refused"], 0) << row["map"];
}

TEST_F(Stress, WhatIsNoMapIsNamed) {
  write_scene("");
  EXPECT_EQ(stress(), 2);
  EXPECT_THAT(text("out"), HasSubstr("s.toml: found no [[map]]"));
  EXPECT_EQ(shell(programs + "/blockweir stress penalti"), 2);
  EXPECT_THAT(text("out"), HasSubstr("did you mean \"penalty\"?"));
}

}  // namespace
}  // namespace blockweir::test::stress_test
