// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Arches, walls and heaps: the blocks that they produce, and each message about what is wrong in them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/geometry/polygon.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_masonry_test {
namespace {

using namespace blockweir::scene;

/// A scene of nothing but what is generated; the generator's heading is line 7.
std::string scene_of(const std::string& generator) {
  return "[analysis]\nduration_s = 1\n[material.m]\nyoungs_modulus_pa = 1e9\npoissons_ratio = 0.2\n"
         "density_kg_per_m3 = 2000\n" +
         generator;
}

std::vector<Block> blocks_of(const std::string& generator) {
  return read_text(scene_of(generator), "s.toml").scene.blocks;
}

const Block& named(const std::vector<Block>& blocks, const std::string& name) {
  for (const Block& block : blocks) {
    if (block.name == name) return block;
  }
  throw std::out_of_range("no block " + name);
}

double area_of(const std::vector<Block>& blocks, bool fixed) {
  double sum = 0;
  for (const Block& block : blocks) sum += block.fixed == fixed ? geometry::signed_area(block.vertices) : 0;
  return sum;
}

const std::string wall = "[[wall]]\nname = 'w'\nmaterial = 'm'\nbrick_length_m = 0.5\nbrick_height_m = 0.2\n";
const std::string arch = "[[arch]]\nname = 'a'\nmaterial = 'm'\nmean_radius_m = 10\nthickness_m = 1.2\n";
const std::string heap = "[[heap]]\nname = 'h'\nmaterial = 'm'\nwidth_m = 5\nsize_m = 0.9\n";

TEST(SceneWall, RunningBondShiftsEveryOtherRow) {
  const auto blocks = blocks_of(wall + "rows = 3\ncolumns = 4\norigin_m = [1, 2]\nfixed_base = true\n");
  ASSERT_EQ(blocks.size(), 4U + 5U + 4U);
  EXPECT_NEAR(area_of(blocks, true) + area_of(blocks, false), 3 * 0.2 * 4 * 0.5, 1e-12);
  EXPECT_NEAR(area_of(blocks, true), 0.4, 1e-12);
  EXPECT_NEAR(geometry::signed_area(named(blocks, "w2-1").vertices), 0.05, 1e-12);
  EXPECT_NEAR(geometry::signed_area(named(blocks, "w2-2").vertices), 0.1, 1e-12);
  EXPECT_TRUE(geometry::centroid(named(blocks, "w2-2").vertices).isApprox(Point(1.5, 2.3)));
  EXPECT_TRUE(geometry::centroid(named(blocks, "w3-1").vertices).isApprox(Point(1.25, 2.5)));
}

TEST(SceneWall, StackedBondDoesNot) {
  const auto blocks = blocks_of(wall +
                                "rows = 3\ncolumns = 4\nbond = 'stacked'\nfixed_base = true\n"
                                "initial_velocity_m_per_s = [1, 0]\n");
  ASSERT_EQ(blocks.size(), 12U);
  for (const Block& block : blocks) {
    EXPECT_NEAR(geometry::signed_area(block.vertices), 0.1, 1e-12);
    EXPECT_EQ(block.initial_velocity_m_per_s, Point(1, 0));
  }
}

TEST(SceneArch, ItsVoussoirsFillTheRing) {
  const auto blocks = blocks_of(arch + "voussoirs = 40\nembrace_deg = 120\n");
  ASSERT_EQ(blocks.size(), 42U);
  EXPECT_TRUE(named(blocks, "a-left").fixed);
  EXPECT_TRUE(named(blocks, "a-right").fixed);
  const double angle = 2 * std::numbers::pi / 3 / 40;
  const double voussoir = (10.6 * 10.6 - 9.4 * 9.4) / 2 * std::sin(angle);  // between two chords
  EXPECT_NEAR(area_of(blocks, false), 40 * voussoir, 1e-9);
  EXPECT_EQ(
      blocks_of("[[block]]\nname = 'g'\nmaterial = 'm'\nfixed = true\nvertices_m = [[-20, -1], [20, -1], [20, 0], "
                "[-20, 0]]\n" +
                arch + "voussoirs = 7\nspringings = false\n")
          .size(),
      8U);
}

TEST(SceneHeap, IsTheSameForASeedAndConvex) {
  const std::string small = heap + "blocks = 30\n";
  const auto blocks = blocks_of(small + "seed = 3\n");
  ASSERT_EQ(blocks.size(), 33U);  // the reader itself refuses blocks that overlap
  EXPECT_EQ(blocks, blocks_of(small + "seed = 3\n"));
  EXPECT_NE(blocks, blocks_of(small + "seed = 4\n"));
  for (const Block& block : blocks) {
    const auto& v = block.vertices;
    EXPECT_EQ(block.fixed, block.name.find('-') != std::string::npos) << block.name;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Point in = v[(i + 1) % v.size()] - v[i];
      const Point out = v[(i + 2) % v.size()] - v[(i + 1) % v.size()];
      EXPECT_GT(in.x() * out.y() - in.y() * out.x(), 0) << block.name;
    }
    if (block.fixed) continue;
    for (const Point& p : v) {
      EXPECT_GT(p.x(), 0) << block.name;
      EXPECT_LT(p.x(), 5) << block.name;
      EXPECT_GT(p.y(), 0) << block.name;
      for (const Point& q : v) EXPECT_LE((p - q).norm(), 0.9 + 1e-12) << block.name;
    }
  }
}

TEST(SceneMasonry, CountsAreRequiredAndBounded) {
  sample::expect_error(scene_of(wall + "columns = 2\n"), 7, {"has no \"rows\"", "a whole number from 1"});
  sample::expect_error(scene_of(wall + "rows = 2\n"), 7, {"has no \"columns\"", "add columns = ..."});
  sample::expect_error(scene_of(arch), 7, {"has no \"voussoirs\""});
  sample::expect_error(scene_of(wall + "rows = 0\ncolumns = 2\n"), 12, {"rows"});
  sample::expect_error(scene_of(wall + "rows = 1001\ncolumns = 100\n"), 7, {"has 100100 blocks", "at most 100000"});
  sample::expect_error(scene_of(arch + "voussoirs = 10001\n"), 12,
                       {"voussoirs in [[arch]] \"a\" is 10001", "a whole number from 1 to 10000"});
  sample::expect_error(scene_of(arch + "voussoirs = 5000\n" + wall + "rows = 951\ncolumns = 100\n"), 13,
                       {"has 95100 blocks, beside 5002", "at most 100000"});
}

TEST(SceneMasonry, MeasuresAreAboveZero) {
  sample::expect_error(scene_of(sample::with("0.5", "0", wall) + "rows = 1\ncolumns = 1\n"), 10,
                       {"brick_length_m", "a number above 0, below 1e6"});
  sample::expect_error(scene_of(sample::with("0.2", "-1", wall) + "rows = 1\ncolumns = 1\n"), 11, {"brick_height_m"});
  sample::expect_error(scene_of(sample::with("= 10", "= 0", arch) + "voussoirs = 3\n"), 10, {"mean_radius_m"});
  sample::expect_error(scene_of(sample::with("1.2", "10", arch) + "voussoirs = 3\n"), 11,
                       {"thickness_m", "a number above 0, below mean_radius_m"});
  sample::expect_error(scene_of(arch + "voussoirs = 3\nembrace_deg = 181\n"), 13,
                       {"embrace_deg", "an angle above 0, up to 180 degrees"});
  sample::expect_error(scene_of(sample::with("= 5", "= -5", heap)), 10, {"width_m"});
  sample::expect_error(scene_of(sample::with("0.9", "0", heap)), 11, {"size_m"});
}

TEST(SceneMasonry, BricksTooThinForTheirPlaceAreRefused) {
  const std::string thin = sample::with("0.2", "1e-300", wall) + "rows = 1\ncolumns = 1\n";
  sample::expect_error(scene_of(thin), 7, {"block \"w1-1\" of [[wall]] \"w\"", "correct the measures"});
}

TEST(SceneMasonry, NamesMaterialsAndBondsAreKnown) {
  sample::expect_error(scene_of(sample::with("'m'", "'n'", heap)), 9, {"\"n\""});
  sample::expect_error(scene_of(wall + "rows = 1\ncolumns = 1\nbond = 'stack'\n"), 14,
                       {"\"stack\"", "expected one of running, stacked"});
  const auto twice = sample::errors(scene_of(heap + heap));
  EXPECT_THAT(twice, testing::Contains(testing::HasSubstr("a second block is called \"h-floor\"")));
}

TEST(SceneHeap, ItMayStandOnGroundOfTheScenesOwnWithStonesOfAsManyCornersAsItSays) {
  const std::string ground =
      "[[block]]\nname = 'g'\nmaterial = 'm'\nfixed = true\nvertices_m = [[-9, -1], [9, -1], [9, 0], [-9, 0]]\n";
  const auto blocks = blocks_of(ground + heap + "blocks = 7\ncorners = 8\nbox = false\n");
  ASSERT_EQ(blocks.size(), 8U);
  for (const Block& block : blocks) EXPECT_EQ(block.vertices.size(), block.fixed ? 4U : 8U) << block.name;
}

TEST(SceneHeap, ItsBlocksFitTheBox) {
  sample::expect_error(scene_of(sample::with("0.9", "6", heap)), 7,
                       {"has 20 blocks of 6 m in a box of 5 m", "none wider than the box"});
  sample::expect_error(scene_of(heap + "blocks = 100001\n"), 12, {"is 100001", "a whole number from 1 to 100000"});
  sample::expect_error(scene_of(heap + "blocks = 0\n"), 12, {"blocks"});
  sample::expect_error(scene_of(heap + "seed = -1\n"), 12, {"seed"});
  sample::expect_error(scene_of(heap + "corners = 2\n"), 12, {"corners", "3"});
}

}  // namespace
}  // namespace blockweir::scene_masonry_test
