// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene
// Which blocks nothing holds where the scene draws them.
#include "bridge/scene/loose_blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace blockweir::scene::loose_blocks_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

void add(Scene& scene, double x, double y, bool fixed = false) {
  Block block;
  block.name = "b" + std::to_string(scene.blocks.size());
  block.material = 0;
  block.fixed = fixed;
  block.vertices = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
  scene.blocks.push_back(block);
}

/// Fixed ground b0, b1 on it, and b2 on that.
Scene wall() {
  Scene scene;
  scene.materials.push_back({"m", 1e9, 0.2, 2000});
  scene.analysis.failure_displacement_m = 1e-3;
  add(scene, 0, -1, true);
  add(scene, 0.3, 0);
  add(scene, 0.6, 1);
  return scene;
}

TEST(LooseBlocks, AreThoseThatTouchNothingHeld) {
  Scene scene = wall();
  EXPECT_THAT(loose_blocks(scene), IsEmpty());
  add(scene, 0.6, 2.0009);  // within the failure displacement
  EXPECT_THAT(loose_blocks(scene), IsEmpty());
  add(scene, 0.6, 3.01);
  add(scene, 0.9, 4.01);  // on the loose one
  EXPECT_THAT(loose_blocks(scene), ElementsAre(4, 5));
  scene.analysis.gravity_m_per_s2 = 0;
  EXPECT_THAT(loose_blocks(scene), IsEmpty());
}

TEST(LooseBlocks, ACornerOnAnEdgeIsHeld) {
  Scene scene = wall();
  scene.blocks[2].vertices = {{0.8, 1}, {1.3, 1.5}, {0.8, 2}, {0.3, 1.5}};
  EXPECT_THAT(loose_blocks(scene), IsEmpty());
  for (Point& p : scene.blocks[2].vertices) p.y() += 0.01;
  EXPECT_THAT(loose_blocks(scene), ElementsAre(2));
}

/// A stone beside a wall, as of a heap that begins in the air: a gap on its side holds nothing, a touching face may.
TEST(LooseBlocks, AGapBesideABlockDoesNotHoldIt) {
  for (const double tilt_deg : {0.0, 10.0, -10.0}) {
    for (const double gap_m : {0.0, 0.5e-3}) {
      Scene scene = wall();
      scene.analysis.gravity_tilt_deg = tilt_deg;
      add(scene, 1.6 + gap_m, 1.5);
      const Point along = Eigen::Rotation2Dd(tilt_deg * std::numbers::pi / 180) * Point(1, 0);
      for (Block& block : scene.blocks) {  // turned with gravity
        for (Point& p : block.vertices) p = p.x() * along + p.y() * Point(-along.y(), along.x());
      }
      EXPECT_EQ(loose_blocks(scene).empty(), gap_m == 0) << tilt_deg << ' ' << gap_m;
    }
  }
}

TEST(LooseBlocks, WhatOnlyFallsIsJudged) {
  Scene scene;
  scene.materials.push_back({"m", 1e9, 0.2, 2000});
  add(scene, 0, -1, true);
  add(scene, 0, 1);
  EXPECT_THAT(loose_blocks(scene), IsEmpty());
}

TEST(LooseBlocks, ABoltASupportAndHeavierWaterHold) {
  Scene scene = wall();
  add(scene, 5, 5);
  EXPECT_THAT(loose_blocks(scene), ElementsAre(3));
  Scene bolted = scene;
  bolted.bolts.push_back({.name = "rope", .blocks = {3, 2}});
  EXPECT_THAT(loose_blocks(bolted), IsEmpty());
  Scene hung = scene;
  hung.supports.push_back({.block = 3});
  EXPECT_THAT(loose_blocks(hung), IsEmpty());
  scene.fluid = FluidModel::hydrostatic;
  scene.materials[0].density_kg_per_m3 = 900;
  EXPECT_THAT(loose_blocks(scene), IsEmpty());
}

TEST(LooseBlocks, AreHeldForAnswersAtRestAndNamed) {
  Scene scene = wall();
  EXPECT_EQ(hold_loose_blocks(scene), "");
  for (int i = 0; i < 5; ++i) add(scene, 5, 2.0 * i + 5);
  EXPECT_THAT(hold_loose_blocks(scene), testing::StartsWith("5 blocks (\"b3\", \"b4\", \"b5\" and 2 more) fall "
                                                            "from the start, as nothing holds what the scene draws"));
  EXPECT_TRUE(scene.blocks[7].fixed);
  EXPECT_FALSE(scene.blocks[1].fixed);
}

}  // namespace
}  // namespace blockweir::scene::loose_blocks_test
