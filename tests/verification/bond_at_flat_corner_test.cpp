// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// A bonded block on a slope whose ground turns a little beyond the toe: strains take the toe past that corner. The bond
// is that of its own face, however flat the corner is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::bond_at_flat_corner_test {
namespace {

double factor_by_blocks(double slope, double beyond, double width, double height, double push_n, double friction_deg,
                        double cohesion_pa) {
  const double toe = slope * width;
  const std::string text = fmt::format(
      R"(analysis = {{ duration_s = 1 }}
material.m = {{ youngs_modulus_pa = 5e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-5, -9], [9, -9], [9, {}], [{}, {}], [0, 0], [-5, -2]]
[[block]]
name = "block"
material = "m"
vertices_m = [[0, 0], [{}, {}], [{}, {}], [0, {}]]
[[joints]]
name = "base"
between = ["rock", "block"]
friction_angle_deg = {}
cohesion_pa = {}
keeps_cohesion = true
[[point_load]]
block = "block"
point_m = [0, {}]
force_n_per_m = [{}, 0]
)",
      toe + beyond * (9 - width), width, toe, width, toe, width, height, height, friction_deg, cohesion_pa, width / 3,
      push_n);
  return process::safety_answer(scene::read_text(text, "corner.toml").scene, hydrostatic::make)["factor"];
}

/// Sliding along the face: F = (c L + N tan phi) / T.
TEST(BondAtFlatCorner, HoldsAlongItsWholeFace) {
  std::mt19937 random(7);
  const auto between = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
  for (int n = 0; n < 12; ++n) {
    const double slope = between(0.02, 0.12);
    const double beyond = slope - between(0.055, 0.12);  // it turns down by 3 to 7 degrees
    const double width = between(0.5, 4);
    const double height = slope * width + width * between(0.8, 1.5);
    const double weight = 2300 * 9.81 * width * (height - slope * width / 2);
    const double push = weight * between(0.15, 0.25);
    const double friction_deg = between(25, 40);
    const double cohesion = weight / width * between(0.05, 0.2);
    const double angle = std::atan(slope);
    const double shear = push * std::cos(angle) - weight * std::sin(angle);
    const double normal = weight * std::cos(angle) + push * std::sin(angle);
    const double exact =
        (cohesion * width / std::cos(angle) + normal * std::tan(friction_deg * std::numbers::pi / 180)) / shear;
    EXPECT_NEAR(factor_by_blocks(slope, beyond, width, height, push, friction_deg, cohesion) / exact, 1, 1e-3)
        << "scene " << n << ", slope " << slope << ", ground beyond " << beyond;
  }
}

}  // namespace
}  // namespace blockweir::test::bond_at_flat_corner_test
