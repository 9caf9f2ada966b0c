// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// A crack's end that no open water reaches is told of where it has a pool's pressure.
#include "fluid/hydrostatic/crack_ends.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fluid/hydrostatic/hydrostatic_model.hpp"

namespace blockweir::hydrostatic::crack_ends_test {
namespace {

/// Two boxes of 4 x 2 m on ground; the second one's base, on the land side, is called "dry".
scene::Scene two_on_ground() {
  scene::Scene scene;
  scene.water.open_crack_width_m = 0.01;
  scene.blocks.push_back({.name = "ground", .vertices = {{-10, -1}, {20, -1}, {20, 0}, {-10, 0}}, .fixed = true});
  scene.blocks.push_back({.name = "dam", .vertices = {{0, 0}, {4, 0}, {4, 2}, {0, 2}}});
  scene.blocks.push_back({.name = "house", .vertices = {{8, 0}, {12, 0}, {12, 2}, {8, 2}}});
  scene.joints.push_back({.name = "wet", .between = {0, 1}, .law = {.uplift = scene::Uplift::triangular}});
  scene.joints.push_back({.name = "dry", .between = {0, 2}, .law = {.uplift = scene::Uplift::triangular}});
  return scene;
}

TEST(CrackEnds, AreToldOfWhereNoWaterReachesThem) {
  const scene::Scene scene = two_on_ground();
  const std::vector<scene::Crack> cracks = scene::find_cracks(scene);
  ASSERT_EQ(cracks.size(), 2U);
  std::vector<std::vector<Point>> outlines;
  for (const scene::Block& block : scene.blocks) outlines.push_back(block.vertices);
  const std::vector<WetInterval> water = {{.block = 1, .edge = 3, .s_from = 0.5, .s_to = 1}};  // the dam's lower metre
  CrackEnds ends(scene, cracks);
  ends.look(0, {true, Point(0, 0), 9810}, outlines, water);
  EXPECT_EQ(ends.warning(), "");
  ends.look(1, {false, Point(12, -8e-6), 0.08}, outlines, water);  // a toe that has settled below the tailwater
  EXPECT_EQ(ends.warning(), "");
  ends.look(1, {true, Point(8, 0), 9810}, outlines, water);
  EXPECT_THAT(ends.warning(), testing::AllOf(testing::HasSubstr("upstream end of joint \"dry\" at (8, 0) m"),
                                             testing::HasSubstr("9810 Pa, all the same"),
                                             testing::HasSubstr("state uplift = \"none\"")));
}

/// Its water may come by the other crack.
TEST(CrackEnds, OnAnotherCrackAreNotJudged) {
  scene::Scene scene = two_on_ground();
  scene.blocks[2].vertices = {{4, 0}, {8, 0}, {8, 2}, {4, 2}};
  scene.joints[1].law.uplift = scene::Uplift::full;  // else both are one crack
  const std::vector<scene::Crack> cracks = scene::find_cracks(scene);
  ASSERT_EQ(cracks.size(), 2U);
  CrackEnds ends(scene, cracks);
  ends.look(1, {true, Point(4, 0), 9810}, {}, {});
  EXPECT_EQ(ends.warning(), "");
}

/// A dam that has slid over its ground's end takes its crack with it.
TEST(CrackEnds, OfBlocksThatHaveFallenAreNotJudged) {
  for (const double fallen_m : {0.0, 10.0}) {
    scene::Scene scene = two_on_ground();
    scene.joints.erase(scene.joints.begin());
    scene.water.upstream_level_m = scene::TimeTable::constant(1);
    HydrostaticModel model(scene);
    wire::Motion motion;
    motion.displacement.own().resize(scene.blocks.size());
    motion.velocity.own().resize(scene.blocks.size());
    motion.displacement.own()[0][1] = motion.displacement.own()[2][1] = -fallen_m;
    wire::Load load;
    model.advance(motion, 0, load);
    EXPECT_EQ(model.report().warnings.empty(), fallen_m > 0) << fallen_m;
  }
}

/// Its toe stood at (4, 0) m, where it now lies on its ground, with water all around it.
TEST(CrackEnds, OfADamThatHasSlidAreNotJudged) {
  scene::Scene scene = two_on_ground();
  scene.joints.pop_back();
  scene.blocks.pop_back();
  scene.water.upstream_level_m = scene::TimeTable::constant(1.5);
  scene.water.downstream_level_m = scene::TimeTable::constant(1);
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  for (const double slid_m : {0.0, 0.7}) {
    motion.displacement.own()[1][0] = slid_m;
    wire::Load load;
    model.advance(motion, slid_m, load);
  }
  EXPECT_THAT(model.report().warnings, testing::IsEmpty());
}

/// A block has come down before the toe, of a dam that stands.
TEST(CrackEnds, ThatWhatHasFallenShutsOffAreNotJudged) {
  scene::Scene scene = two_on_ground();
  scene.joints.pop_back();
  scene.blocks.back().vertices = {{14, 3}, {18, 3}, {18, 5}, {14, 5}};
  scene.water.upstream_level_m = scene::TimeTable::constant(1.5);
  scene.water.downstream_level_m = scene::TimeTable::constant(1);
  for (const bool drawn : {false, true}) {
    if (drawn) scene.blocks.back().vertices = {{4, 0}, {8, 0}, {8, 2}, {4, 2}};
    HydrostaticModel model(scene);
    wire::Motion motion;
    motion.displacement.own().resize(scene.blocks.size());
    motion.velocity.own().resize(scene.blocks.size());
    for (const double fallen : {0.0, 1.0}) {
      if (!drawn) {
        motion.displacement.own()[2][0] = -10 * fallen;
        motion.displacement.own()[2][1] = -3 * fallen;
      }
      wire::Load load;
      model.advance(motion, fallen, load);
    }
    EXPECT_EQ(model.report().warnings.empty(), !drawn);
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic::crack_ends_test
