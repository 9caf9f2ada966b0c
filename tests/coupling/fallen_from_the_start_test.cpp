// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// A heap that falls beside a wall, and a wall whose crest sinks below the water: what a run says of them.
#include "tests/processes.hpp"

namespace blockweir::test::fallen_from_the_start_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class FallenFromTheStart : public Processes {
 protected:
  /// A wall on rock, 5 m high, its base so wide, before water of this depth.
  void write_scene(double base_m, double level_m, const std::string& more = "") const {
    std::ofstream(folder / "s.toml")
        << "analysis = { duration_s = 2 }\njoint = { friction_angle_deg = 50 }\nwater = { upstream_level_m = "
        << level_m << " }\nmaterial.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }\n"
        << "[[block]]\nname = \"rock\"\nmaterial = \"m\"\nfixed = true\n"
        << "vertices_m = [[-10, -3], [22, -3], [22, 0], [-10, 0]]\n"
        << "[[block]]\nname = \"wall\"\nmaterial = \"m\"\nvertices_m = [[0, 0], [" << base_m
        << ", 0], [1, 5], [0, 5]]\n"
        << more;
  }
  [[nodiscard]] nlohmann::json run() const {
    EXPECT_EQ(shell(programs + "/blockweir run s.toml --inproc --quiet --out o"), 0) << text("out");
    return nlohmann::json::parse(text("o/summary.json"));
  }
};

const std::string stones =
    "[[block]]\nname = \"stone a\"\nmaterial = \"m\"\nvertices_m = [[6, 0.5], [7, 0.5], [7, 1.5], [6, 1.5]]\n"
    "[[block]]\nname = \"stone b\"\nmaterial = \"m\"\nvertices_m = [[6, 1.7], [7, 1.7], [7, 2.5], [6, 2.5]]\n";

TEST_F(FallenFromTheStart, StonesInTheAirDoNotTakeTheWallsVerdict) {
  write_scene(2.5, 2, stones);
  const auto summary = run();
  EXPECT_EQ(summary["outcome"], "stands");
  EXPECT_EQ(summary["loose"]["blocks"], nlohmann::json({"stone a", "stone b"}));
  EXPECT_GT(summary["limit_analysis"]["factor"].get<double>(), 1);
  EXPECT_THAT(text("out"), HasSubstr("LOOSE   2 blocks (\"stone a\" and \"stone b\") fall from the start, as nothing "
                                     "holds what the scene draws there: the verdict is that of the others\n"));
}

/// On rock that ends at 22 m, and beside a wall that supports lead.
TEST_F(FallenFromTheStart, WhereAllThatCouldFailIsLooseNothingIsJudged) {
  write_scene(
      2.5, 2,
      "[[support]]\nblock = \"wall\"\npoint_m = [0, 0]\ndisplacement_x_m = 0\ndisplacement_y_m = 0\n"
      "[[support]]\nblock = \"wall\"\npoint_m = [0, 5]\ndisplacement_x_m = 0\n"
      "[[block]]\nname = \"stone\"\nmaterial = \"m\"\nvertices_m = [[21.9, 0.5], [23, 0.5], [23, 1.5], [21.9, 1.5]]\n");
  EXPECT_EQ(run()["outcome"], "stands");
  EXPECT_THAT(text("out"), HasSubstr("STANDS  nothing was judged: all blocks that could fail fall from the start\n"));
  EXPECT_THAT(text("out"), HasSubstr("at the end 1 had left the model, below its lowest point"));
}

TEST_F(FallenFromTheStart, LevelAndSafetyAnswerForTheWallAndNameTheStones) {
  write_scene(2.5, 2);
  for (const std::string command : {"level", "safety"}) {
    EXPECT_EQ(shell(programs + "/blockweir " + command + " s.toml"), 0) << text("out");
    const std::string alone = text("out");
    write_scene(2.5, 2, stones);
    EXPECT_EQ(shell(programs + "/blockweir " + command + " s.toml"), 0) << text("out");
    EXPECT_THAT(text("out"), HasSubstr("WARNING 2 blocks (\"stone a\" and \"stone b\") fall from the start"));
    EXPECT_THAT(text("out"), HasSubstr(alone.substr(0, 30)));
    write_scene(2.5, 2);
  }
}

TEST_F(FallenFromTheStart, AWallThatFailsBesideThemIsTheFailure) {
  write_scene(1.2, 4.8, stones);
  const auto summary = run();
  EXPECT_EQ(summary["failure"]["blocks"], nlohmann::json({"wall"}));
}

TEST_F(FallenFromTheStart, ACrestThatSinksBelowTheWaterIsABreachAtOnce) {
  write_scene(1.2, 4.8);
  const auto summary = run();
  EXPECT_EQ(summary["failure"]["mode"], "overturning");
  const double time_s = summary["breach"]["time_s"];
  EXPECT_NEAR(summary["breach"]["crest_m"].get<double>(), 4.8, 0.1);
  EXPECT_GT(time_s, 0.2);
  EXPECT_LT(time_s, 1.2);
  EXPECT_THAT(text("out"), HasSubstr("s: water at a level of 4.8 m flows over the crest, which has sunk to 4.7"));
}

TEST_F(FallenFromTheStart, AnErrorInALoadCaseOrStudyIsFoundBeforeTheRun) {
  write_scene(2.5, 2,
              "[[load_case]]\nname = \"a\"\nset = [\"joint.friction_angle_deg=-3\"]\n"
              "[[load_case]]\nname = \"b\"\nset = [\"water.upstream_level_m=9\"]\n"
              "[[study]]\nname = \"c\"\nkind = \"map\"\nx_key = \"joint.frction\"\nx_values = [1, 2]\n"
              "y_key = \"water.upstream_level_m\"\ny_values = [1, 2]\n");
  for (const std::string command :
       {"run s.toml --out o", "level s.toml --out o", "safety s.toml --out o", "modes s.toml --out o",
        "reliability s.toml --out o", "report s.toml --run o", "validate s.toml"}) {
    EXPECT_EQ(shell(programs + "/blockweir " + command), 2) << command;
    EXPECT_THAT(text("out"),
                AllOf(HasSubstr("[[load_case]] \"a\" sets joint.friction_angle_deg=-3"),
                      HasSubstr("[[load_case]] \"b\" sets water.upstream_level_m=9"), HasSubstr("frction")))
        << command;
    EXPECT_FALSE(std::filesystem::exists(folder / "o")) << command;
  }
}

}  // namespace
}  // namespace blockweir::test::fallen_from_the_start_test
