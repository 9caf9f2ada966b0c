// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit bridge_scene_read
// What retains water stands on the ground: levels go up to its top, and each structure is looked at by itself.
#include "bridge/scene/standing_groups.hpp"

#include "bridge/scene/crest.hpp"
#include "solid/limit/level_range.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::standing_groups_test {
using namespace blockweir::scene;

namespace {

const std::string rock_and_wall = R"(analysis = { duration_s = 1 }
joint = { friction_angle_deg = 30 }
material.m = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -3], [12, -3], [12, 0], [-10, 0]]
[[block]]
name = "foot"
material = "m"
vertices_m = [[0, 0], [2.5, 0], [2.5, 2], [0, 2]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 2], [2.5, 2], [1, 5], [0, 5]]
)";
const std::string house = R"([[block]]
name = "house"
material = "m"
vertices_m = [[6, 0], [10, 0], [10, 7], [6, 7]]
)";
const std::string deck = R"([[block]]
name = "deck"
material = "m"
vertices_m = [[0, 8], [10, 8], [10, 9], [0, 9]]
[[support]]
block = "deck"
point_m = [0, 8]
displacement_x_m = 0
displacement_y_m = 0
[[support]]
block = "deck"
point_m = [10, 8]
displacement_y_m = 0
)";

std::string water(double level_m) {
  return "water.upstream_level_m = " + std::to_string(level_m) + "\n";
}

TEST(StandingGroups, AreBlocksThatTouch) {
  const StandingGroups groups = standing_groups(read_text(rock_and_wall + house + deck, "s").scene.blocks);
  EXPECT_EQ(groups.of_block, (std::vector<int>{-1, 0, 0, 1, 2}));
  ASSERT_EQ(groups.all.size(), 3U);
  EXPECT_EQ(groups.all[0].top_m, 5);
  EXPECT_EQ(groups.all[0].foot_m, 0);
  EXPECT_EQ(groups.all[0].highest, 2);
  EXPECT_TRUE(groups.all[1].on_ground);
  EXPECT_FALSE(groups.all[2].on_ground);
  EXPECT_EQ(retaining_top_m(groups), 7);
}

TEST(StandingGroups, AllStandWhereNoneTouchesTheGround) {
  std::vector<Block> blocks = read_text(rock_and_wall + deck, "s").scene.blocks;
  blocks[0].fixed = false;
  const StandingGroups groups = standing_groups(blocks);
  for (std::size_t b = 0; b < blocks.size(); ++b) EXPECT_TRUE(groups.on_ground(b));
}

TEST(StandingGroups, ADeckOnItsOwnSupportsIsNoCrest) {
  const Scene scene = read_text(water(4.9) + rock_and_wall + deck, "s").scene;
  EXPECT_EQ(crest_of(scene.blocks).height_m, 5);
  EXPECT_EQ(solid::limit::level_range(scene).full_m, 5);
  EXPECT_THROW(read_text(water(5.5) + rock_and_wall + deck, "s"), SceneError);
}

TEST(StandingGroups, EachTopIsALevelToLookFrom) {
  const solid::limit::LevelRange range = solid::limit::level_range(read_text(rock_and_wall + house, "s").scene);
  ASSERT_EQ(range.lower_tops_m.size(), 1U);
  EXPECT_DOUBLE_EQ(range.lower_tops_m[0], 5 - 1e-3 * 5);
  EXPECT_EQ(range.full_m, 7);
  EXPECT_TRUE(solid::limit::level_range(read_text(rock_and_wall, "s").scene).lower_tops_m.empty());
}

TEST(StandingGroups, ALevelThatDrownsOneOfThemIsWarnedOf) {
  EXPECT_TRUE(read_text(water(4.9) + rock_and_wall + house, "s").warnings.empty());
  const auto warnings = read_text(water(5.5) + rock_and_wall + house, "s").warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].found.find("upstream_level_m reaches 5.5 m, above \"wall\" and all that touches it, up to 5 m: "
                                   "they then stand in water on both sides, as \"house\" holds it back"),
            std::string::npos)
      << warnings[0].text();
}

}  // namespace
}  // namespace blockweir::standing_groups_test
