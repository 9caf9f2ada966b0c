// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// A block on a slope that is too steep for it, with an anchor that is slack: what stops it after it has slid as far as
// a failure does not make it stand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/capacity/static_level.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/step/solid.hpp"
#include "tests/independent/random_structures.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::test::slack_anchors_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Anchored {
  std::string text;
  double factor;  ///< of the friction, without the anchor
  bool rigid;
};

/// Its anchor lies along the slope and pulls with next to nothing until the block has slid far.
Anchored random_anchored(std::uint64_t seed) {
  independent::Random random(seed, "slack");
  const double size = random.between_orders(0.1, 100);
  const double slope_deg = random.between(10, 40);
  const double factor = random.between(0.5, 1.5);
  const double friction_deg = std::atan(factor * std::tan(slope_deg * degree)) / degree;
  const double height = size * random.between(0.3, 1);
  const double weight = 2300 * 9.81 * 2 * size * height;
  const double failure_m = 1e-3 * size;
  const bool rigid = random.chance(0.5);
  return {
      fmt::format(R"(analysis = {{ duration_s = 1, gravity_tilt_deg = {}, rigid = "{}", failure_displacement_m = {} }}
joint = {{ friction_angle_deg = {} }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[{}, {}], [{}, {}], [{}, 0], [{}, 0]]
[[block]]
name = "block"
material = "m"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
[[bolt]]
name = "anchor"
from_block = "block"
from_m = [0, {}]
to_block = "rock"
to_m = [{}, {}]
stiffness_n_per_m2 = {}
)",
                  slope_deg, rigid ? "all" : "named", failure_m, friction_deg, -9 * size, -size, 9 * size, -size,
                  9 * size, -9 * size, 2 * size, 2 * size, height, height, 1e-9 * size, -8 * size, -1e-9 * size,
                  1e-4 * weight / failure_m),
      factor, rigid};
}

TEST(SlackAnchors, DoNotMakeABlockStandThatSlidesAsFarAsAFailure) {
  for (int seed = 1; seed <= campaign(30); ++seed) {
    const Anchored drawn = random_anchored(static_cast<std::uint64_t>(seed));
    const scene::Scene scene = scene::read_text(drawn.text, "slack").scene;
    SCOPED_TRACE(fmt::format("seed {}, factor {}\n{}", seed, drawn.factor, drawn.text));
    solid::Solid solid(scene);
    solid.settle({});
    EXPECT_EQ(solid.starts_at_rest(), drawn.factor > 1);
    const solid::StaticStrength found = solid::static_strength(scene, nullptr, 0, 1);
    ASSERT_EQ(found.bearing, solid::limit::Bearing::fails_at_a_factor);
    EXPECT_GT(found.factor, (1 - 1e-6) * drawn.factor);
    EXPECT_LT(found.factor, (1 + 2e-3) * drawn.factor);
  }
}

/// A wall in two lifts that a soft anchor holds: it gives way a little at each level, until that adds up to a failure.
std::string random_wall(std::uint64_t seed) {
  independent::Random random(seed, "soft");
  const double size = random.between_orders(0.1, 100);
  const double breadth = size * random.between(0.5, 0.8);
  const double lift = size * random.between(0.3, 0.7);
  const double friction_deg = random.between(15, 30);
  const double failure_m = 2e-3 * size;
  const double friction = 2300 * 9.81 * breadth * size * std::tan(friction_deg * degree);
  return fmt::format(R"(analysis = {{ duration_s = 1, rigid = "{0}", failure_displacement_m = {1} }}
joint = {{ friction_angle_deg = {2} }}
water = {{ upstream_level_m = 0, may_overtop = true }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[{3}, {4}], [{5}, {4}], [{5}, 0], [{3}, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [{6}, 0], [{6}, {7}], [0, {7}]]
[[block]]
name = "cap"
material = "m"
vertices_m = [[0, {7}], [{6}, {7}], [{6}, {8}], [0, {8}]]
[[bolt]]
name = "anchor"
from_block = "wall"
from_m = [{9}, {10}]
to_block = "rock"
to_m = [{11}, {12}]
stiffness_n_per_m2 = {13}
)",
                     random.chance(0.5) ? "all" : "named", failure_m, friction_deg, -9 * size, -size, 9 * size, breadth,
                     lift, size, 0.1 * size, 1e-3 * size, -8 * size, -1e-3 * size,
                     random.between(0.02, 0.1) * friction / failure_m);
}

TEST(SlackAnchors, TheBodyIsNamedWhoseSlipsAddUpToAFailure) {
  for (int seed = 1; seed <= campaign(10); ++seed) {
    const std::string text = random_wall(static_cast<std::uint64_t>(seed));
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, text));
    const scene::Scene scene = scene::read_text(text, "soft").scene;
    solid::StillWater water(scene, hydrostatic::make);
    const solid::StaticLevel found = solid::static_level(scene, water, 1e-4);
    ASSERT_EQ(found.outcome, solid::limit::Filled::fails);
    EXPECT_TRUE(found.slips_add_up);
    ASSERT_TRUE(found.failure);
    EXPECT_EQ(found.failure->blocks, (std::vector{1, 2}));
    EXPECT_EQ(found.failure->joint, "wall on rock");
    EXPECT_EQ(found.failure->mode, "sliding");
    EXPECT_NEAR(found.failure->head_m, found.failure->level_m, 1e-9);
  }
}

}  // namespace
}  // namespace blockweir::test::slack_anchors_test
