// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// An exchange that makes energy ends the run, or is its result; one that does not is left alone.
#include "tests/processes.hpp"

namespace blockweir::test::interface_energy_test {
namespace {

using testing::HasSubstr;

class InterfaceEnergy : public Processes {
 protected:
  [[nodiscard]] int run(const std::string& more) const {
    fs::remove_all(folder / "r");
    return shell(programs + "/blockweir run " + cases + "piston-column --out r --quiet" + more);
  }
  [[nodiscard]] nlohmann::json energy() const {
    return nlohmann::json::parse(text("r/summary.json"))["interface_energy"];
  }
};

const std::string unguarded =
    " --set coupling.added_mass_guard=false --set coupling.added_mass_limit=10 --set analysis.integrator=shi";

TEST_F(InterfaceEnergy, HeavyWaterWithoutTheGuardIsRefusedUnlessTheSceneTakesTheRisk) {
  EXPECT_EQ(run(" --set coupling.added_mass_guard=false"), 1);
  EXPECT_THAT(text("out"), HasSubstr("has to push water 3 times as heavy as itself; without the added-mass guard the "
                                     "exchange is unstable above 1"));
  EXPECT_EQ(run(unguarded + " --set coupling.added_mass_limit=2"), 1);
  EXPECT_THAT(text("out"), HasSubstr("unstable above 2"));
}

TEST_F(InterfaceEnergy, ARunThatGrowsIsStoppedWithItsWindowCauseAndRemedy) {
  EXPECT_EQ(run(unguarded), 1);
  EXPECT_THAT(text("out"), HasSubstr("the exchange between blocks and water adds energy from window "));
  EXPECT_THAT(text("out"), HasSubstr("a block has to push water 3 times as heavy as itself, without the "
                                     "added-mass guard; set [coupling] added_mass_guard = true"));
  const auto found = energy();
  EXPECT_TRUE(found["grows"].get<bool>());
  EXPECT_LT(found["window"].get<int>(), 10);
}

/// What blocks move as they settle is before the first exchange.
TEST_F(InterfaceEnergy, ADamAtRestHasMadeNone) {
  EXPECT_EQ(shell(programs + "/blockweir run " + cases +
                  "monolith-overturns --inproc --out r --quiet --set water.upstream_level_m=5 --set "
                  "analysis.duration_s=1 --set analysis.rigid=none"),
            0);
  EXPECT_LT(std::abs(energy()["made_j_per_m"].get<double>()), 1e-6);
}

TEST_F(InterfaceEnergy, OrReportsItWhereTheSceneAsksForThat) {
  EXPECT_EQ(run(unguarded + " --set coupling.on_energy_gain=report"), 0) << text("out");
  EXPECT_TRUE(energy()["grows"].get<bool>());
}

TEST_F(InterfaceEnergy, LighterWaterAndGuardedWaterDoNotGrow) {
  EXPECT_EQ(run(unguarded + " --set fluid.column.length_m=0.9"), 0) << text("out");
  EXPECT_FALSE(energy()["grows"].get<bool>());
  EXPECT_EQ(run(" --set fluid.column.length_m=100"), 0) << text("out");
  EXPECT_FALSE(energy()["grows"].get<bool>());
}

/// Pressures of a window's start push a box that floats ever farther, by 0.25 % a window: too little to end the run.
TEST_F(InterfaceEnergy, ABoxThatSwingsEverFartherIsWarnedOfAndOneThatDoesNotIsNot) {
  std::ofstream(folder / "s.toml") << R"(
analysis = { duration_s = 8, step_s = 0.02, start = "unstressed", rigid = "all" }
joint = { friction_angle_deg = 30 }
water = { upstream_level_m = 0, downstream_level_m = 0, may_overtop = true }
material.wood = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 500 }
[[block]]
name = "bed"
material = "wood"
vertices_m = [[-4, -2.5], [4, -2.5], [4, -2], [-4, -2]]
fixed = true
[[block]]
name = "box"
material = "wood"
vertices_m = [[-0.5, -0.19], [0.5, -0.19], [0.5, 0.21], [-0.5, 0.21]]
)";
  const auto warnings = [&](const char* more) {
    fs::remove_all(folder / "r");
    EXPECT_EQ(shell(programs + "/blockweir run s.toml --inproc --out r --quiet" + more), 0) << text("out");
    return nlohmann::json::parse(text("r/summary.json"))["warnings"].dump();
  };
  EXPECT_THAT(warnings(""), HasSubstr("times the largest kinetic energy: pressures that lag behind the blocks push"));
  EXPECT_THAT(warnings(" --set coupling.schedule=improved"), testing::Not(HasSubstr("the exchange between")));
  EXPECT_THAT(warnings(" --set coupling.load_in_window=linear"), testing::Not(HasSubstr("the exchange between")));
}

/// The shaken dam slides, and friction takes most of the water's work. Its slip is right to 1 % (steps of 1 ms), though
/// what the exchange makes is no longer small beside what moves.
TEST_F(InterfaceEnergy, OfADamThatSlidesWhatFrictionTakesCountsToo) {
  std::ofstream(folder / "s.toml") << R"(
analysis = { duration_s = 10, step_s = 0.01, rigid = "all" }
joint = { friction_angle_deg = 38 }
water = { upstream_level_m = 35 }
fluid = { model = "reservoir" }
base_motion = { acceleration_x_m_per_s2 = { sine = 4, frequency_hz = 2 } }
material.concrete = { youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
[[block]]
name = "rock"
material = "concrete"
vertices_m = [[-60, -20], [90, -20], [90, 0], [-60, 0]]
fixed = true
[[block]]
name = "dam"
material = "concrete"
vertices_m = [[0, 0], [29, 0], [5, 32], [5, 38], [0, 38]]
)";
  const auto run = [&](const char* more) {
    fs::remove_all(folder / "r");
    EXPECT_EQ(shell(programs + "/blockweir run s.toml --inproc --out r --quiet" + more), 0) << text("out");
    return nlohmann::json::parse(text("r/summary.json"));
  };
  const auto usual = run("");
  EXPECT_THAT(usual["warnings"].dump(), testing::Not(HasSubstr("the exchange between")));
  const double slip = run(" --set analysis.step_s=0.001")["margin"]["slip_m"];
  EXPECT_NEAR(usual["margin"]["slip_m"].get<double>(), slip, 0.01 * slip);
}

/// Elastic energy goes to and fro: a wall that strained under a pond was warned of for 0.02 J.
TEST_F(InterfaceEnergy, OfAWallThatOnlyStrainsNothingIsSaid) {
  std::ofstream(folder / "s.toml") << R"(
analysis = { duration_s = 0.02, step_s = 0.01 }
coupling = { schedule = "improved" }
joint = { friction_angle_deg = 25, uplift = "triangular" }
water = { upstream_level_m = { from = 6.5, rate_per_s = 1.0, to = 7.9 } }
material.brick = { youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[[block]]
name = "rock"
material = "brick"
fixed = true
vertices_m = [[-10, -2], [20, -2], [20, 0], [-10, 0]]
[[wall]]
name = "w"
material = "brick"
brick_length_m = 1
brick_height_m = 0.5
rows = 16
columns = 4
)";
  EXPECT_EQ(shell(programs + "/blockweir run s.toml --inproc --out r --quiet"), 0) << text("out");
  const auto summary = nlohmann::json::parse(text("r/summary.json"));
  EXPECT_EQ(summary["outcome"], "stands");
  EXPECT_THAT(summary["warnings"].dump(), testing::Not(HasSubstr("the exchange between")));
}

/// Springs that stand took up 2.3 mJ: the run was refused as unstable.
TEST_F(InterfaceEnergy, ADamOnSpringsStandsUnderTheParallelSchedule) {
  std::ofstream(folder / "s.toml") << R"(
analysis = { duration_s = 0.24, step_s = 0.003130492508, integrator = "shi", rigid = "all" }
contact = { formulation = "penalty" }
coupling = { schedule = "parallel", window_s = 0.006260985016 }
water = { upstream_level_m = { from = 1.1710419, rate_per_s = 2.4295795, to = 1.9011968 } }
joint = { friction_angle_deg = 40.222, uplift = "none" }
material.m = { youngs_modulus_pa = 3.91999e9, poissons_ratio = 0.2, density_kg_per_m3 = 1879.83 }
[section]
material = "m"
outline_m = [[0, 0], [1.45448190606, 0], [0.297289896536, 1.95999666856], [0, 1.95999666856]]
[[joint_set]]
name = "bed"
dip_deg = 13.889
spacing_m = 0.14
offset_m = 0.075992
friction_angle_deg = 38.849
[[joint_set]]
name = "cross"
dip_deg = 61.459
spacing_m = 0.113282
offset_m = 0.0514941
[[block]]
name = "ground"
material = "m"
vertices_m = [[-4, -0.4], [8, -0.4], [8, 0], [-4, 0]]
fixed = true
)";
  EXPECT_EQ(shell(programs + "/blockweir run s.toml --inproc --out r --quiet"), 0) << text("out");
  EXPECT_FALSE(energy()["grows"].get<bool>());
}

}  // namespace
}  // namespace blockweir::test::interface_energy_test
