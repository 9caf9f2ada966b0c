// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Joint sets leave tips of a few centimetres at the face of a slope. Corners pass over offsets as small as that, which
// must not let the tips fall through what they stand on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bridge/scene/read/read.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::tiny_blocks_test {
namespace {

/// A tip on the corner of a block of soft rock, as wide as high.
scene::Scene tip_on_corner(double tip_m) {
  return scene::read_text(fmt::format(R"(analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 35 }}
material.m = {{ youngs_modulus_pa = 0.2e9, poissons_ratio = 0.2, density_kg_per_m3 = 2600 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -5], [15, -5], [15, 0], [-10, 0]]
[[block]]
name = "left"
material = "m"
vertices_m = [[0, 0], [3, 0], [3, 8], [0, 8]]
[[block]]
name = "right"
material = "m"
vertices_m = [[3, 0], [6, 0], [6, 8], [3, 8]]
[[block]]
name = "tip"
material = "m"
vertices_m = [[{0}, 8], [6, 8], [6, {1}], [{0}, {1}]]
)",
                                      6 - tip_m, 8 + tip_m),
                          "tip")
      .scene;
}

TEST(TinyBlocks, StandOnACorner) {
  for (int seed = 1; seed <= test::campaign(4); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const double tip_m = random.over_decades(0.005, 0.2);
    Solid solid(tip_on_corner(tip_m));
    solid.settle({});
    EXPECT_TRUE(solid.starts_at_rest()) << tip_m;
    const auto& states = solid.states();
    EXPECT_NEAR(states[3].displacement[1], states[2].displacement[1], 0.005) << tip_m;
  }
}

}  // namespace
}  // namespace blockweir::solid::tiny_blocks_test
