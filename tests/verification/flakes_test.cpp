// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_answers bridge_scene_read
// Joint sets cut flakes off a section, as thin as chance will have it: they stand with what they lie on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/read/read.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "solid/capacity/static_strength.hpp"
#include "tests/independent/random_structures.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::test::flakes_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A dry wall on level rock; its courses dip, and blocks slide down them one by one.
std::string random_wall(std::uint64_t seed, double& dip_deg) {
  independent::Random random(seed, "flakes");
  const double size = random.between_orders(0.1, 100);
  dip_deg = random.between(1.5, 6) * (random.chance(0.5) ? 1 : -1);
  return fmt::format(R"(analysis = {{ duration_s = 1, rigid = "{}" }}
joint = {{ friction_angle_deg = 40 }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[{}, {}], [{}, {}], [{}, 0], [{}, 0]]
[section]
material = "m"
outline_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
[[joint_set]]
name = "courses"
dip_deg = {}
spacing_m = {}
offset_m = {}
friction_angle_deg = 30
[[joint_set]]
name = "cross joints"
dip_deg = 90
spacing_m = {}
offset_m = {}
friction_angle_deg = 30
)",
                     random.chance(0.5) ? "all" : "named", -2 * size, -2 * size, 5 * size, -2 * size, 5 * size,
                     -2 * size, 3 * size, 3 * size, 3 * size, 3 * size, dip_deg, random.between(0.8, 1.4) * size,
                     random.between(0, 3) * size, random.between(0.9, 2) * size, random.between(0, 4) * size);
}

TEST(Flakes, StandAsWhatTheyLieOnDoes) {
  int cut = 0;
  for (int seed = 1; seed <= campaign(30); ++seed) {
    double dip_deg = 0;
    const std::string text = random_wall(static_cast<std::uint64_t>(seed), dip_deg);
    const scene::Scene scene = scene::read_text(text, "flakes").scene;
    if (scene.blocks.size() < 3) continue;
    ++cut;
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, text));
    const double slides = std::tan(30 * degree) / std::tan(std::abs(dip_deg) * degree);
    for (const double nearly : {0.998, 1.002}) {
      solid::SearchBudget effort("flakes");
      const scene::Scene reduced = solid::with_reduced_strength(scene, nearly * slides);
      EXPECT_EQ(solid::StaticBlocks(reduced, nullptr, effort).begin(0), nearly < 1);
    }
  }
  EXPECT_GT(cut, campaign(30) / 2);
}

}  // namespace
}  // namespace blockweir::test::flakes_test
