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

}  // namespace
}  // namespace blockweir::test::interface_energy_test
