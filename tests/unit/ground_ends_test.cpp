// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// Which faces on a model's ends are cuts in ground that goes on, and which are walls in water.
#include "bridge/scene/ground_ends.hpp"

#include <gmock/gmock.h>

#include "fluid/hydrostatic/hydrostatic_model.hpp"

namespace blockweir::hydrostatic::ground_ends_test {
namespace {

using Outline = std::vector<Point>;

scene::Scene scene_of(const std::vector<Outline>& held, const std::vector<Outline>& movable, double level_m) {
  scene::Scene scene;
  scene.materials.push_back({"stone", 50e9, 0.2, 2500});
  for (const auto* outlines : {&held, &movable}) {
    for (const Outline& outline : *outlines) {
      scene::Block& block = scene.blocks.emplace_back();
      block.name = "b" + std::to_string(scene.blocks.size());
      block.vertices = outline;
      block.fixed = outlines == &held;
    }
  }
  scene.water.upstream_level_m = scene::TimeTable::constant(level_m);
  return scene;
}

const Outline ground = {{-20, -6}, {40, -6}, {40, 0}, {-20, 0}};
const Outline dam = {{0, 0}, {12, 0}, {3, 20}, {0, 20}};

TEST(GroundEnds, GroundUnderWaterGoesOnBeyondBothEnds) {
  const scene::GroundEnds ends = find_ground_ends(scene_of({ground}, {dam}, 15));
  ASSERT_TRUE(ends.left && ends.right);
  EXPECT_EQ(ends.left->block, 0);
  EXPECT_EQ(ends.left->vertex, 3);
  EXPECT_EQ(ends.right->vertex, 2);
}

TEST(GroundEnds, JointedRockOnAFixedBaseIsGroundUpToItsBed) {
  const scene::GroundEnds ends = find_ground_ends(
      scene_of({{{-20, -15}, {50, -15}, {50, -12}, {-20, -12}}},
               {{{-20, -12}, {50, -12}, {50, -5}, {-20, -7}}, {{-20, -7}, {50, -5}, {50, 0}, {-20, 0}}, dam}, 15));
  ASSERT_TRUE(ends.left && ends.right);
  EXPECT_EQ(ends.left->block, 2);
  EXPECT_EQ(ends.left->vertex, 3);
  EXPECT_EQ(ends.right->block, 2);
}

TEST(GroundEnds, GroundThatIsSupportedIsGround) {
  scene::Scene scene = scene_of({}, {ground, dam}, 15);
  EXPECT_FALSE(find_ground_ends(scene).left);  // it could be a raft
  scene.supports.push_back({0, Point(-20, -6), {}, scene::TimeTable::constant(0)});
  EXPECT_TRUE(find_ground_ends(scene).left);
}

TEST(GroundEnds, WallsAreNoGround) {
  const auto is_ground = [](const std::vector<Outline>& held, const std::vector<Outline>& movable, double level_m) {
    return find_ground_ends(scene_of(held, movable, level_m)).left.has_value();
  };
  const Outline wall = {{0, 0}, {4, 0}, {4, 10}, {0, 10}};
  const Outline cap = {{1, 10}, {3, 10}, {3, 11}, {1, 11}};
  EXPECT_FALSE(is_ground({wall}, {cap}, 10)) << "full to its top";
  EXPECT_FALSE(is_ground({wall}, {cap}, 10.5)) << "overtopped: what stands on it is too near to its edge";
  EXPECT_FALSE(is_ground({wall}, {}, 12)) << "nothing stands on it";
  EXPECT_FALSE(is_ground({{{0, -2}, {12, -2}, {12, 0}, {0, 0}}}, {dam}, 15)) << "a foundation as wide as its dam";
  EXPECT_FALSE(is_ground({{{0, -2}, {30, -2}, {30, 0}, {0, 0}}},
                         {{{0, 0}, {30, 0}, {30, 10}, {0, 10}}, {{20, 10}, {24, 10}, {24, 13}, {20, 13}}}, 8))
      << "a quay whose deck is dry";
  EXPECT_FALSE(is_ground({{{-2, 0}, {20, 0}, {14, 15}, {0, 15}}}, {}, 14)) << "an end that is a foot";
}

TEST(GroundEnds, TheSceneDecidesOtherwise) {
  scene::Scene rock = scene_of({ground}, {dam}, 15);
  rock.water.wets_ends = true;
  EXPECT_FALSE(find_ground_ends(rock).left);
  scene::Scene narrow = scene_of({}, {{{-2, -10}, {30, -10}, {30, 0}, {-2, 0}}, dam}, 15);
  EXPECT_FALSE(find_ground_ends(narrow).left);
  narrow.water.wets_ends = false;
  EXPECT_TRUE(find_ground_ends(narrow).left);
}

TEST(GroundEnds, TheReportSaysWhichAreDry) {
  scene::Scene scene = scene_of({ground}, {dam}, 15);
  const auto said = [&] { return HydrostaticModel(scene).report().skips; };
  const char* left =
      "water on the model's left end below 0 m: a dry cut through ground that continues ([water] wets_ends = true wets "
      "it)";
  EXPECT_THAT(said(), testing::Contains(left));
  scene.water.wets_ends = true;
  EXPECT_THAT(said(), testing::Not(testing::Contains(testing::HasSubstr("wets_ends"))));
}

TEST(GroundEnds, ThePoolIsNotBesideTheGroundEither) {
  scene::Scene scene = scene_of({ground}, {dam}, 15);
  scene.output.reservoir = true;
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(2);
  wire::Load load;
  model.advance(motion, 0, load);
  ASSERT_EQ(model.sections().size(), 1U);
  for (const Ring& ring : model.sections()[0].region) {
    for (const Point& p : ring) EXPECT_GT(p.y(), -1e-9) << p.transpose();
  }
}

TEST(GroundEnds, BelowALightBlockWithoutGroundThereIsWater) {
  scene::Scene raft = scene_of({}, {{{0, 0}, {8, 0}, {8, 2}, {0, 2}}}, 1);
  EXPECT_FALSE(lowest_floats(raft));
  raft.materials[0].density_kg_per_m3 = 500;
  EXPECT_TRUE(lowest_floats(raft));
  raft.blocks[0].fixed = true;
  EXPECT_FALSE(lowest_floats(raft));
}

}  // namespace
}  // namespace blockweir::hydrostatic::ground_ends_test
