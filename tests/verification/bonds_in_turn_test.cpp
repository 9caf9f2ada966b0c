// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Three blocks lean on each other on a bent slope, with chamfers at its bends. Their bonds to the rock are brittle: the
// first to break decides.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::bonds_in_turn_test {
namespace {

using nlohmann::json;

std::string block(int number, double friction_deg, double cohesion_pa, const std::string& law,
                  const std::string& outline) {
  return fmt::format(
      "[[block]]\nname = \"w{0}\"\nmaterial = \"m\"\nvertices_m = [{4}]\n"
      "[[joints]]\nname = \"p{0}\"\nbetween = [\"rock\", \"w{0}\"]\nfriction_angle_deg = {1}\ncohesion_pa = {2}\n{3}\n",
      number, friction_deg, cohesion_pa, law, outline);
}

/// With a line of the law of all joints to the rock.
json safety_of_slope(const std::string& law) {
  const std::string scene = R"(analysis = { duration_s = 1 }
joint = { friction_angle_deg = 34.95 }
material.m = { youngs_modulus_pa = 54.58e9, poissons_ratio = 0, density_kg_per_m3 = 1979 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[0, 0], [-37.2716, 16.7203], [-83.0499, 56.1594], [-111.9319, 88.6438], [-221, 88.6438], [-221, -163.74], [0, -163.74]]
)";
  const std::string blocks =
      block(0, 36.36, 40e3, law, "[-37.2716, 16.7203], [0, 0], [0, 30.0647], [-54.4243, 58.5474]") +
      block(1, 24.99, 110e3, law,
            "[-83.0499, 56.1594], [-37.3543, 16.7916], [-37.313, 16.8213], [-54.4243, 58.5474], [-87.9807, 76.109]") +
      block(2, 44.79, 150e3, law, "[-111.9319, 88.6438], [-83.1225, 56.241], [-83.0761, 56.2654], [-87.9807, 76.109]");
  return process::safety_answer(scene::read_text(scene + blocks, "slope").scene, hydrostatic::make);
}

TEST(BondsInTurn, AreToldWithTheFactorWithoutThem) {
  const json answer = safety_of_slope("");
  ASSERT_TRUE(answer.contains("without_bonds")) << answer;
  EXPECT_LT(answer["without_bonds"]["factor"].get<double>(), 0.95 * answer["factor"].get<double>());
  EXPECT_THAT(answer["warnings"].dump(), testing::HasSubstr("bonds of joints break one after the other"));
}

TEST(BondsInTurn, AreNotToldOfWhereSlipDoesNotDestroyThem) {
  EXPECT_FALSE(safety_of_slope("keeps_cohesion = true").contains("without_bonds"));
}

/// A wedge of rock on a seam whose bond is brittle; at its back a crack without a bond. The wedge and the dam on it
/// have a bond each, in no common loop of joints.
TEST(BondsInTurn, AreNotToldOfWhereTheLoopHasASingleBond) {
  const auto answer = [](const std::string& crack) {
    const std::string scene = R"(analysis = { duration_s = 1 }
joint = { friction_angle_deg = 35 }
water = { upstream_level_m = 20 }
material.m = { youngs_modulus_pa = 20e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[0, -20], [80, -20], [80, 0], [42, 0], [0, -6]]
[[block]]
name = "upstream rock"
material = "m"
fixed = true
vertices_m = [[-40, -20], [0, -20], [0, 0], [-40, 0]]
[[block]]
name = "wedge"
material = "m"
vertices_m = [[0, 0], [0, -6], [42, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[5, 0], [25, 0], [8, 25], [5, 25]]
[[joints]]
name = "base"
between = ["wedge", "dam"]
cohesion_pa = 200e3
[[joints]]
name = "seam"
between = ["rock", "wedge"]
cohesion_pa = 50e3
[[joints]]
name = "crack"
between = ["upstream rock", "wedge"]
)";
    return process::safety_answer(scene::read_text(scene + crack, "wedge").scene, hydrostatic::make);
  };
  const json one = answer("cohesion_pa = 0");
  EXPECT_NEAR(one["factor"].get<double>(), one["limit_analysis_factor"].get<double>(), 1e-3) << one;
  EXPECT_FALSE(one.contains("without_bonds"));
  EXPECT_TRUE(answer("cohesion_pa = 50e3").contains("without_bonds"));
}

}  // namespace
}  // namespace blockweir::test::bonds_in_turn_test
