// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read bridge_study
// Columns that topple by Goodman and Bray (1976), but whose strain wedges them: `safety` gives the factor without it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/safety.hpp"

namespace blockweir::test::strain_that_holds_test {
namespace {

using nlohmann::json;

constexpr double radian = 3.141592653589793 / 180;

/// The first of four columns on steps that rise with the slope: base planes dip by 17.6 degrees.
std::string columns(std::size_t count) {
  constexpr double width = 2.307136;
  constexpr double dip = 17.608 * radian;
  const std::array<double, 4> steps = {0, 0.31753, 0.64877, 0.98318};
  const std::array<double, 4> tops = {6.67385, 7.74327, 9.23497, 10.44788};
  const auto point = [&](double along, double up) {
    return fmt::format("[{:.12g}, {:.12g}]", -along * width * std::cos(dip) + up * std::sin(dip),
                       along * width * std::sin(dip) + up * std::cos(dip));
  };
  std::string rock;
  std::string blocks;
  for (std::size_t k = 0; k < count; ++k) {
    const auto n = static_cast<double>(k);
    rock += ", " + point(n, steps[k]) + ", " + point(n + 1, steps[k]);
    blocks += fmt::format(
        "[[block]]\nname = \"c{0}\"\nmaterial = \"m\"\nvertices_m = [{1}, {2}, {3}, {4}]\n"
        "[[joints]]\nname = \"base c{0}\"\nbetween = [\"rock\", \"c{0}\"]\nfriction_angle_deg = 50\n",
        k, point(n + 1, steps[k]), point(n, steps[k]), point(n, tops[k]), point(n + 1, tops[k]));
  }
  return fmt::format(R"(analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 40.91 }}
material.m = {{ youngs_modulus_pa = 23e9, poissons_ratio = 0.2, density_kg_per_m3 = 2375 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [{}, {}{}]
{})",
                     point(7, -20), point(-1, -20), rock, blocks);
}

TEST(StrainThatHolds, IsToldWithTheFactorWithoutIt) {
  const json answer = process::safety_answer(scene::read_text(columns(4), "columns").scene, hydrostatic::make);
  EXPECT_GT(answer["factor"].get<double>(), 1.5);
  ASSERT_TRUE(answer.contains("with_rigid_blocks")) << answer["warnings"];
  EXPECT_LT(answer["with_rigid_blocks"]["factor"].get<double>(), 0.9);
  EXPECT_LE(study::deciding_factor(answer), answer["with_rigid_blocks"]["factor"].get<double>());
  EXPECT_THAT(answer["warnings"].dump(), testing::HasSubstr("the same blocks without strain have a factor of"));
}

TEST(StrainThatHolds, IsNotAskedForWhereEquilibriumDeterminesFriction) {
  const json answer = process::safety_answer(scene::read_text(columns(1), "column").scene, hydrostatic::make);
  EXPECT_NEAR(answer["factor"].get<double>(), std::tan(50 * radian) / std::tan(17.608 * radian), 1e-5);
  EXPECT_FALSE(answer.contains("with_rigid_blocks"));
}

/// Ten courses of 25 bricks on ground that slopes by 20 degrees.
constexpr const char* leaning_wall = R"(analysis = { duration_s = 1, gravity_tilt_deg = 20, rigid = "all" }
joint = { friction_angle_deg = 30 }
material.m = { youngs_modulus_pa = 1e8, poissons_ratio = 0.2, density_kg_per_m3 = 2200 }
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-30, -2], [60, -2], [60, 0], [-30, 0]]
[[wall]]
name = "b"
material = "m"
rows = 10
columns = 2
brick_length_m = 1
brick_height_m = 0.5
bond = "running"
)";

TEST(StrainThatLetsGo, IsToldWithTheFactorWithIt) {
  const json answer = process::safety_answer(scene::read_text(leaning_wall, "wall").scene, hydrostatic::make);
  EXPECT_GT(answer["factor"].get<double>(), 1.1);
  ASSERT_TRUE(answer.contains("with_straining_blocks")) << answer["warnings"];
  EXPECT_LT(answer["with_straining_blocks"]["factor"].get<double>(), 0.9);
  EXPECT_LE(study::deciding_factor(answer), answer["with_straining_blocks"]["factor"].get<double>());
  EXPECT_THAT(answer["warnings"].dump(), testing::HasSubstr("the same blocks with strain have a factor of"));
}

TEST(StrainThatLetsGo, IsToldBesideTheLevel) {
  const std::string pushed = "[[body_load]]\nacceleration_x_m_per_s2 = 3\n[water]\nupstream_level_m = 1\n";
  const scene::Scene scene = scene::read_text(leaning_wall + pushed, "wall", {"analysis.gravity_tilt_deg=0"}).scene;
  const json answer = process::level_answer(scene, hydrostatic::make);
  EXPECT_THAT(answer["warnings"].dump(), testing::HasSubstr("with strain the same blocks do not stand at"));
}

}  // namespace
}  // namespace blockweir::test::strain_that_holds_test
