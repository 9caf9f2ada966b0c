// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What a run is warned of and what it does not hold, as the programs say it.
#include <cmath>

#include "tests/processes.hpp"

namespace blockweir::test::said_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Said : public Processes {
 protected:
  [[nodiscard]] nlohmann::json summary() const { return nlohmann::json::parse(text("o/summary.json")); }
  void scene(const std::string& content) const { std::ofstream(folder / "s.toml") << content; }
};

const std::string block = R"([analysis]
duration_s = 0.1
[material.m]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2.4
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-2, -1], [6, -1], [6, 0], [-2, 0]]
[[block]]
name = "block"
material = "m"
vertices_m = [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]
)";

TEST_F(Said, APathThatOpenFoamWouldChangeIsRefusedBeforeAnythingStarts) {
  for (const char* out : {"'of sp'", "\"of'q\""}) {
    EXPECT_EQ(shell(programs + "/blockweir run " + cases + "hydrostatic-wall-openfoam --out " + out), 2);
    EXPECT_THAT(text("out"), AllOf(HasSubstr("expected a path without blanks and quotes, which OpenFOAM drops from "
                                             "paths; choose another --out, or work in another folder")));
  }
  EXPECT_FALSE(fs::exists(folder / "of sp"));
}

TEST_F(Said, AnOutThatCannotBeAPathIsRefused) {
  const std::string run = programs + "/blockweir run " + cases + "incline --out ";
  EXPECT_EQ(shell(run + "''"), 2);
  EXPECT_THAT(text("out"), HasSubstr("--out: found an empty text; expected the path of a folder or file"));
  EXPECT_EQ(shell(run + "a/" + std::string(300, 'b')), 2);
  EXPECT_THAT(text("out"), HasSubstr("--out: found a name of 300 bytes, \"bbbbbbbbbbbbbbbbbbbb...\"; expected names "
                                     "of at most 255 bytes; choose another"));
  EXPECT_FALSE(fs::exists(folder / "a"));
}

/// Before the run and after it, and by `check`.
TEST_F(Said, AnEarthquakeThatCountsTwiceAndABlockThatIsTornAreNamed) {
  std::string torn = block;
  torn.replace(torn.find("2.4"), 3, "2400");
  for (const auto& [x, way] : {std::pair{"0.2", "0"}, std::pair{"0.8", "{ from = 0, rate_per_s = 1, to = 0.1 }"}}) {
    torn += std::string("[[support]]\nblock = \"block\"\npoint_m = [") + x + ", 0.2]\ndisplacement_x_m = " + way + "\n";
  }
  scene(torn +
        "[earthquake]\nhorizontal_coefficient = 0.1\n[base_motion]\nacceleration_x_m_per_s2 = { sine = 1, "
        "frequency_hz = 2 }\n");
  ASSERT_EQ(shell(programs + "/blockweir check s.toml"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("s.toml: warning: a run has the earthquake twice: "));
  ASSERT_EQ(shell(programs + "/blockweir run s.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), AllOf(HasSubstr("s.toml: warning: a run has the earthquake twice: "),
                                 HasSubstr("WARNING a run has the earthquake twice: "),
                                 HasSubstr("WARNING block \"block\" is strained by 0.1"),
                                 HasSubstr("its 2 supports pull it apart or together")));
  EXPECT_EQ(shell(programs + "/blockweir run s.toml --out strict --strict"), 2);
  ASSERT_EQ(shell(programs + "/blockweir safety s.toml"), 0) << text("out");
  EXPECT_THAT(text("out"), Not(HasSubstr("twice")));
}

/// Springs that give way by a centimetre, and by a micrometre.
TEST_F(Said, BlocksThatAreInEachOtherAreNamed) {
  std::string heavy = block;
  heavy.replace(heavy.find("2.4"), 3, "2400");
  for (const char* stiffness : {"1e6", "1e10"}) {
    scene(heavy + "[contact]\nformulation = \"penalty\"\nstiffness_n_per_m2 = " + stiffness + "\n");
    ASSERT_EQ(shell(programs + "/blockweir run s.toml --out o" + stiffness), 0) << text("out");
    const auto said = HasSubstr("WARNING blocks were in each other by up to ");
    const auto advice = HasSubstr("1e-4 of the model's size; raise [contact] stiffness_n_per_m2");
    if (stiffness == std::string("1e6")) {
      EXPECT_THAT(text("out"), AllOf(said, advice, HasSubstr("the scene has chosen 1e+06 N/m2")));
    } else {
      EXPECT_THAT(text("out"), Not(said));
    }
  }
}

/// A stone falls on another's edge: soft stones are in each other by what their corners may pass over.
TEST_F(Said, OverlapsOfSoftStonesNameTheStrainsAndTheOtherFormulation) {
  const std::string heap = R"(
analysis = { duration_s = 1, step_s = 0.005, rigid = "none" }
joint = { friction_angle_deg = 25 }
material.s = { youngs_modulus_pa = 1e7, poissons_ratio = 0.2, density_kg_per_m3 = 2600 }
[[heap]]
name = "st"
material = "s"
width_m = 4
size_m = 0.4
blocks = 30
seed = 7630
[[expect]]
quantity = "invariants"
word = "hold"
)";
  scene(heap);
  ASSERT_EQ(shell(programs + "/blockweir run s.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), AllOf(HasSubstr("WARNING blocks were in each other by up to "),
                                 HasSubstr("their corners may be in each other by up to 0.00"),
                                 HasSubstr("state rigid = \"all\" in [analysis]")));
  EXPECT_GT(summary()["largest_overlap_m"].get<double>(), 4e-4);
}

TEST_F(Said, AWarningStandsBeforeTheRunInItsReportAndInItsSummary) {
  scene(block);
  ASSERT_EQ(shell(programs + "/blockweir run s.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr("s.toml:6: warning: density_kg_per_m3 in [material.m] is 2.4 kg/m3"));
  EXPECT_THAT(text("out"), HasSubstr("WARNING density_kg_per_m3 in [material.m] is 2.4 kg/m3, which is unusual"));
  EXPECT_THAT(summary()["warnings"].at(0).get<std::string>(), HasSubstr("if it is in t/m3, write 2400"));
}

TEST_F(Said, StrictMakesAnErrorOfAWarning) {
  scene(block);
  EXPECT_EQ(shell(programs + "/blockweir check s.toml"), 0);
  EXPECT_THAT(text("out"), AllOf(HasSubstr("s.toml:6: warning: density"), HasSubstr("sound, with 1 warning")));
  EXPECT_EQ(shell(programs + "/blockweir check s.toml --strict"), 2);
  EXPECT_THAT(text("out"), HasSubstr("s.toml:6: error: density"));
  EXPECT_EQ(shell(programs + "/blockweir run s.toml --strict --out o"), 2);
  EXPECT_FALSE(fs::exists(folder / "o"));
  EXPECT_EQ(shell(programs + "/blockweir run s.toml --strict --out o --set material.m.density_kg_per_m3=2400"), 0);
}

TEST_F(Said, CheckAndCutCountTheSameJointsAndLoadCases) {
  scene(block + "[[load_case]]\nname = 'slippery'\nset = ['joint.friction_angle_deg=6']\n" +
        "[section]\nmaterial = 'm'\noutline_m = [[2, -1], [5, -1], [5, 2], [2, 2]]\n"
        "[[region]]\nmaterial = 'm'\nfixed = true\noutline_m = [[2, -1], [5, -1], [5, 1], [2, 1]]\n"
        "[[cut]]\nname = 'through'\npoints_m = [[3, -1], [3, 2]]\n");
  EXPECT_EQ(shell(programs + "/blockweir check s.toml --set block.ground.vertices_m=[[-2,-1],[1.5,-1],[1.5,0],[-2,0]]"),
            0)
      << text("out");
  // The cut parts the fixed rock, too, where no joint moves; the block on the ground has a joint without a name.
  EXPECT_THAT(text("out"), HasSubstr("6 blocks, 4 joints (3 with a name), 0 variants, 1 load case, 0 studies"));
  EXPECT_EQ(shell(programs + "/blockweir cut s.toml --set block.ground.vertices_m=[[-2,-1],[1.5,-1],[1.5,0],[-2,0]]"),
            0)
      << text("out");
  EXPECT_THAT(text("out"), HasSubstr("6 blocks (3 fixed) of"));
  EXPECT_THAT(text("out"), HasSubstr(", 4 joints; drawn in"));
}

TEST_F(Said, SuggestedCommandsAreQuotedForTheShell) {
  scene(block);
  ASSERT_EQ(shell(programs + "/blockweir run s.toml --out \"it's so\""), 0) << text("out");
  EXPECT_THAT(text("out"), HasSubstr(R"("blockweir plot 'it'\''s so'" draws figures)"));
}

TEST_F(Said, CheckWarnsOfVariantsToo) {
  scene(block + "[[variant]]\nname = \"slippery\"\nset = [\"joint.friction_angle_deg=0.6\"]\n");
  EXPECT_EQ(shell(programs + "/blockweir check s.toml --strict --set material.m.density_kg_per_m3=2400"), 2);
  EXPECT_THAT(
      text("out"),
      HasSubstr("s.toml:16: error: [[variant]] \"slippery\" sets joint.friction_angle_deg=0.6: friction_angle_deg "
                "in [joint] is 0.6 deg"));
}

TEST_F(Said, CheckNamesTheLengthsThatFollowTheStructure) {
  scene(block);
  ASSERT_EQ(shell(programs + "/blockweir check s.toml"), 0);
  EXPECT_THAT(text("out"), HasSubstr("structure of 1 m: failure_displacement_m = 0.001, rest_speed_m_per_s = "));
}

TEST_F(Said, AFigureOfNothingIsFoundBeforeTheRun) {
  scene(block + "[[expect]]\nquantity = \"displacement_m\"\nvalue = 0\nof = \"\"\n");
  for (const std::string command : {"check s.toml", "run s.toml --out o"}) {
    EXPECT_EQ(shell(programs + "/blockweir " + command), 2);
    EXPECT_THAT(text("out"), HasSubstr("s.toml:19: error: quantity displacement_m in [[expect]] has no of"));
  }
  EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST_F(Said, AnEndpointWithoutWaterIsRefused) {
  scene(block);
  EXPECT_EQ(shell(programs + "/blockweir-solid s.toml --out o --endpoint ipc://" + (folder / "line").string()), 2);
  EXPECT_THAT(text("out"), HasSubstr("the scene has no water to exchange; add [water] with a level to it, or leave"));
  EXPECT_FALSE(fs::exists(folder / "o"));
}

TEST_F(Said, AnEndpointThatIsNoneIsAWrongCommandAndLeavesNoFolder) {
  scene(block + "[water]\nupstream_level_m = 0.5\n");
  for (const std::string endpoint : {"foo", "tcp://127.0.0.1", "ipc:///nowhere/line"}) {
    EXPECT_EQ(shell(programs + "/blockweir-solid s.toml --out o --endpoint " + endpoint), 2) << endpoint;
    EXPECT_THAT(text("out"), HasSubstr("endpoint " + endpoint + ": "));
    EXPECT_EQ(shell(programs + "/blockweir-hydrostatic s.toml --endpoint " + endpoint), 2) << endpoint;
    EXPECT_FALSE(fs::exists(folder / "o"));
  }
}

TEST_F(Said, ADryRunSaysNothingOfALevel) {
  scene(block);
  ASSERT_EQ(shell(programs + "/blockweir-solid s.toml --out o"), 0) << text("out");
  EXPECT_THAT(text("out"), AllOf(HasSubstr("largest displacement"), Not(HasSubstr("nan")), Not(HasSubstr("level"))));
}

TEST_F(Said, ARockingBlockThatHasNotSwungBackHasNoImpactRatio) {
  for (const auto& [duration, period, ratio] :
       {std::tuple{"0.6", false, false}, {"1.33", true, false}, {"2.2", true, true}}) {
    fs::remove_all(folder / "o");
    ASSERT_EQ(
        shell(programs + "/blockweir run " + cases + "rocking --quiet --out o --set analysis.duration_s=" + duration),
        0);
    const auto checks = summary()["checks"];
    EXPECT_EQ(checks[0]["got"].is_number(), period) << duration;
    EXPECT_EQ(checks[1]["got"].is_number(), ratio) << duration;
    if (!period) EXPECT_EQ(checks[0]["why_none"], "no impact: the run ends before it");
    if (ratio) continue;
    EXPECT_FALSE(checks[1]["passed"]);
    EXPECT_THAT(text("out"),
                HasSubstr(", no second impact: the run ends before the block has swung back (tolerance 0.1)"));
  }
}

TEST_F(Said, FiguresThatARunDoesNotHoldSayWhy) {
  const auto why = [&](const std::string& run, const std::string& expect) {
    fs::remove_all(folder / "o");
    EXPECT_EQ(shell(programs + "/blockweir run " + run + " --quiet --out o --set \"expect=[" + expect + "]\""), 0)
        << text("out");
    return summary()["checks"][0].value("why_none", "a figure");
  };
  const std::string scene_of = cases;
  EXPECT_EQ(why(scene_of + "bounce --set analysis.duration_s=0.02", "{quantity='rebound_ratio',value=1,of='mass'}"),
            "no rebound: the run ends while the contact still pushes");
  EXPECT_EQ(why(scene_of + "bounce --set analysis.duration_s=0.01", "{quantity='rebound_ratio',value=1,of='mass'}"),
            "no rebound: the run ends before it");
  EXPECT_EQ(why(scene_of + "contact-spectrum --set analysis.duration_s=0.03 --set analysis.step_s=0.001",
                "{quantity='oscillation_period_s',value=1,of='mass'}"),
            "no whole period: the run ends before it");
  EXPECT_EQ(why(scene_of + "arch --set arch.0.thickness_m=1.5", "{quantity='hinges',value=5,of='arch'}"),
            "no mechanism: the arch stands");
  EXPECT_EQ(
      why(scene_of + "bar-wave --set analysis.duration_s=1e-3", "{quantity='wave_speed_m_per_s',value=1,of='s40'}"),
      "no front: the run ends before it has passed the block");
  scene(block);
  EXPECT_EQ(why("s.toml", "{quantity='failure_time_s',value=1}"), "no failure");
  EXPECT_EQ(why("s.toml", "{quantity='pile_width_m',value=1}"),
            "no pile: no two blocks that can move touch each other");
  EXPECT_EQ(why("s.toml", "{quantity='acceleration_m_per_s2',value=1,of='block'}"),
            "no motion: the block stays where it is");
  EXPECT_EQ(why("s.toml", "{quantity='angular_momentum_error',value=1,of='block'}"),
            "no angular momentum to keep: the block does not spin at first");
  EXPECT_EQ(why("s.toml", "{quantity='oscillation_period_s',value=1,of='block'}"),
            "no oscillation: the block does not move");
}

TEST_F(Said, WaterThatStandsAboveTheCrestIsLeftOutWithAWord) {
  const auto warnings = [&](const std::string& level) {
    fs::remove_all(folder / "o");
    EXPECT_EQ(shell(programs + "/blockweir run " + cases +
                    "monolith-slides --inproc --quiet --out o --set expect=[] --set analysis.duration_s=0.1 --set "
                    "joint.friction_angle_deg=60 --set water.may_overtop=true --set water.upstream_level_m=" +
                    level),
              0)
        << text("out");
    return summary()["warnings"].dump();
  };
  EXPECT_THAT(warnings("6.5"), Not(HasSubstr("crest")));
  EXPECT_THAT(warnings("8.5"),
              HasSubstr("the water rose to 8.5 m, 0.5 m above the crest; unless both pools are above the crest, the "
                        "weight of the water on it is left out"));
  EXPECT_THAT(warnings("8.5 --set water.downstream_level_m=8.5"), Not(HasSubstr("crest")));
}

}  // namespace
}  // namespace blockweir::test::said_test
