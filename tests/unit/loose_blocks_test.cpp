// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene bridge_scene_read
// Which blocks nothing holds where the scene draws them.
#include "bridge/scene/loose_blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene::loose_blocks_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

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

/// Rows of blocks of 2 m x 1 m, left_m and up_m from the middle of the rock.
std::string wall_above_rock(int rows, int columns, double left_m, double up_m, const std::string& more = "") {
  std::string text = R"(
analysis = { duration_s = 1 }
joint = { friction_angle_deg = 30 }
material.stone = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[[block]]
name = "rock"
material = "stone"
fixed = true
vertices_m = [[-30, -3], [30, -3], [30, 0], [-30, 0]]
)";
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = 2 * column - left_m;
      const double y = row + up_m;
      text += fmt::format(
          "[[block]]\nname = 'b{}-{}'\nmaterial = 'stone'\nvertices_m = [[{:.6f}, {:.6f}], [{:.6f}, {:.6f}], [{:.6f}, "
          "{:.6f}], [{:.6f}, {:.6f}]]\n",
          row, column, x, y, x + 2, y, x + 2, y + 1, x, y + 1);
    }
  }
  return text + more;
}

std::vector<std::string> warnings(const std::string& text) {
  return read_text(text, "s.toml").scene.warnings;
}

TEST(LooseBlocks, WallsThatAreAboveTheirRockAreToldOfAndNoOthers) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> rows(1, 6);
  std::uniform_int_distribution<int> columns(1, 6);
  std::uniform_real_distribution<double> share(0, 1);
  for (int n = 0; n < 100; ++n) {
    const int r = rows(random);
    const int c = columns(random);
    const double left_m = 10 * share(random);
    const double up_m = 0.1 + share(random);
    const auto told = warnings(wall_above_rock(r, c, left_m, up_m));
    const std::string words = fmt::format("{} blocks (\"b0-0\"", r * c);
    if (r * c == 1) {  // a stone may be let fall
      EXPECT_THAT(told, Not(Contains(HasSubstr("nothing that holds")))) << n;
    } else {
      EXPECT_THAT(told,
                  Contains(AllOf(HasSubstr(words), HasSubstr("fall from the start, as they touch nothing that holds"))))
          << n;
    }
    EXPECT_THAT(warnings(wall_above_rock(r, c, left_m, 0)), Not(Contains(HasSubstr("nothing that holds")))) << n;
  }
}

TEST(LooseBlocks, WhatACornerASupportOrABoltHoldsIsNone) {
  for (const char* holds :
       {"[[block]]\nname = 'ridge'\nmaterial = 'stone'\nfixed = true\nvertices_m = [[-1, 0], [1, 0], [0, 0.5]]\n",
        "[[support]]\nblock = 'b0-0'\npoint_m = [-1, 0.5]\ndisplacement_y_m = 0\n",
        "[[bolt]]\nname = 'a'\nfrom_block = 'b0-0'\nfrom_m = [-1, 1]\nto_m = [-1, -2]\nyoungs_modulus_pa = 2e11\n"
        "area_m2_per_m = 1e-3\n"}) {
    EXPECT_THAT(warnings(wall_above_rock(2, 2, 2, 0.5, holds)), Not(Contains(HasSubstr("nothing that holds"))))
        << holds;
  }
  EXPECT_THAT(warnings(wall_above_rock(2, 2, 2, 0.5)), Contains(HasSubstr("4 blocks (")));
}

TEST(LooseBlocks, WhatStartsWithoutStressIsMeantToDrop) {
  std::string text = wall_above_rock(2, 2, 2, 0.5);
  text.replace(text.find("duration_s = 1"), 14, "duration_s = 1, start = 'unstressed'");
  EXPECT_THAT(warnings(text), Not(Contains(HasSubstr("nothing that holds"))));
}

}  // namespace
}  // namespace blockweir::scene::loose_blocks_test
