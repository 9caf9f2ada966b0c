// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_report
// What a report takes from a scene and a run.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "bridge/picture/frames_data.hpp"
#include "bridge/picture/history.hpp"
#include "bridge/picture/section_data.hpp"
#include "bridge/report/histories_data.hpp"
#include "bridge/report/report_page.hpp"
#include "bridge/scene/read/read.hpp"
#include "tests/own_folder.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::picture::report_test {
namespace {

using nlohmann::json;

TEST(ReportSection, HasJointsAndDimensionsOfTheScene) {
  const json data = section_data(scene::read_text(scene::sample::text, "s.toml").scene);
  ASSERT_EQ(data["blocks"].size(), 3U);
  EXPECT_EQ(data["joints"][0], json::parse(R"({"name":"crack","lines":[[[0,2],[3,2]]],"labelled":true})"));
  EXPECT_EQ(data["laws"].back()["name"], "all other joints");
  EXPECT_EQ(data["dimensions"], json::parse(R"({"bottom":0,"top":4,"right":3,"base":[0,3],"crest":[0,3]})"));
}

/// Whatever the dip: a base that is no level line has the width of what stands on the ground.
TEST(ReportSection, ABaseThatDipsHasItsWidth) {
  for (const double drop_m : {-2.0, -0.5, 0.0, 0.5, 2.0}) {
    const std::string scene = fmt::format(R"(
analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 45 }}
material.m = {{ youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-9, -9], [18, -9], [18, {0}], [9, {0}], [0, 0], [-9, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[0, 0], [9, {0}], [3, 12], [0, 12]]
)",
                                          -drop_m);
    const json base = section_data(scene::read_text(scene, "s.toml").scene)["dimensions"]["base"];
    EXPECT_EQ(base, json::parse("[0.0, 9.0]")) << drop_m;
  }
}

TEST(ReportSection, NamesTheLawOfTheWaterInEachJoint) {
  const auto water_in = [](const std::vector<std::string>& overrides) {
    return section_data(scene::read_text(scene::sample::text, "s.toml", overrides).scene)["laws"][0]["uplift"];
  };
  for (const char* law : {"none", "triangular", "full", "cracked"}) {
    EXPECT_EQ(water_in({fmt::format("joints.crack.uplift={}", law)}), law);
  }
  EXPECT_EQ(water_in({"joints.crack.uplift=drained", "joints.crack.drain_m=0.5", "joints.crack.drain_efficiency=0.6"}),
            "drained, drain at 0.5 m from the upstream end, efficiency 0.6");
  EXPECT_EQ(water_in({"joints.crack.uplift=heads", "joints.crack.piezometers_m=[[1, 2.5]]",
                      "joints.crack.piezometers_level_m=3"}),
            "heads of 1 piezometer");
}

class ReportRun : public test::OwnFolder {
 protected:
  void write_frames(int count) const {
    std::ofstream frames(folder / "frames.jsonl");
    for (int i = 0; i < count; ++i) {
      frames << R"({"time_s":)" << i << R"(,"upstream_level_m":1,"downstream_level_m":null,"blocks":[)"
             << R"({"fixed":true,"outline":[[-5,-1],[5,-1],[5,0],[-5,0]]},)"
             << R"({"fixed":false,"outline":[[0,0],[1.23456789,0],[1,2],[0,2]]}],"contacts":[[0,0,1],[1,0,0]],)"
             << R"("panels":[[0,0,-5,0,9810,9810,0],[0,1,0,0,0,9810,0]]})"
             << "\n";
    }
  }
};

TEST_F(ReportRun, KeepsPressuresOnBlocksAndContactsThatHold) {
  write_frames(3);
  const json data = frames_data(folder, json::parse(R"({"failure":{"time_s":1.5}})"));
  ASSERT_EQ(data["frames"].size(), 3U);
  EXPECT_EQ(data["pictured"], 1);
  const json& frame = data["frames"][0];
  EXPECT_EQ(frame["panels"], json::parse("[[0,1,0,0,0,9810,0]]"));
  EXPECT_EQ(frame["contacts"].size(), 1U);
  EXPECT_EQ(frame["outlines"][1][1][0].dump(), "1.23457");
  EXPECT_EQ(frame["pools"].size(), 1U);
}

TEST_F(ReportRun, ThinsALongOneAndKeepsItsEnd) {
  write_frames(1000);
  const json frames = frames_data(folder, json::object())["frames"];
  EXPECT_LE(frames.size(), 301U);
  EXPECT_EQ(frames.front()["t"], 0);
  EXPECT_EQ(frames.back()["t"], 999);
}

TEST_F(ReportRun, ShowsTheLastFrameUpToTheFailureHoweverLongTheRun) {
  for (const int count : {5, 301, 1000}) {
    write_frames(count);
    for (const double failure_s : {0.0, 0.5, 1.0, 2.5, 3.0, count - 1.5, count - 1.0}) {
      const json data = frames_data(folder, {{"failure", {{"time_s", failure_s}}}});
      EXPECT_EQ(data["frames"][data["pictured"].get<std::size_t>()]["t"], std::floor(failure_s)) << count;
    }
  }
}

TEST_F(ReportRun, ShowsTheEightThatMoveMost) {
  std::ofstream csv(folder / "history.csv");
  csv << "time_s,upstream_level_m";
  for (int i = 0; i < 12; ++i) csv << ",b" << i << ".displacement_x_m,b" << i << ".displacement_y_m";
  csv << "\n0,nan";
  for (int i = 0; i < 12; ++i) csv << ",0,0";
  csv << "\n1,nan";
  for (int i = 0; i < 12; ++i) csv << "," << i << ",0";
  csv << "\n2,nan,half";
  csv.close();
  const History history(folder / "history.csv");
  EXPECT_EQ(history.rows(), 2U);
  EXPECT_EQ(history.largest_first("displacement_x_m", "displacement_y_m").front(), "b11");
  const json data = histories_data(folder);
  ASSERT_EQ(data["groups"].size(), 2U);
  EXPECT_EQ(data["groups"][0]["curves"].size(), 8U);
  EXPECT_THAT(data["left_out"].get<std::string>(), testing::HasSubstr("all 11 blocks"));
}

TEST(ReportPage, CannotBeEndedByATextOfTheScene) {
  const std::string page = report_page({{"title", "</script>@SCRIPT@"}});
  EXPECT_THAT(page, testing::HasSubstr(R"("\u003c/script>@SCRIPT@")"));
}

}  // namespace
}  // namespace blockweir::picture::report_test
