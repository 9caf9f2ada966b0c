// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// The key mesh_size_m: who has it, and what is refused.
#include <gtest/gtest.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_mesh_test {
using namespace blockweir::scene;
using sample::expect_error;
using sample::with;

namespace {

std::string meshed(const std::string& value, const std::string& name = "base") {
  return with("name = \"" + name + "\"\n", "name = \"" + name + "\"\nmesh_size_m = " + value + "\n");
}

TEST(SceneMesh, ABlockHasTheSizeOfItsTriangles) {
  const auto scene = read_text(meshed("0.5"), "s.toml").scene;
  EXPECT_EQ(scene.blocks[0].mesh_size_m, 0);
  EXPECT_EQ(scene.blocks[1].mesh_size_m, 0.5);
}

TEST(SceneMesh, ASizeOfZeroIsRefused) {
  expect_error(meshed("0"), 21, {"mesh_size_m", "above 0"});
}

TEST(SceneMesh, AFixedBlockTakesNone) {
  expect_error(meshed("0.5", "ground"), 16, {"is fixed and has a mesh_size_m", "leave out one of the two"});
}

TEST(SceneMesh, ARigidBlockTakesNone) {
  expect_error(meshed("0.5\nrigid = true"), 21, {"is rigid and has a mesh_size_m", "where something can strain"});
}

TEST(SceneMesh, MoreTrianglesThanCanBeMeantAreRefused) {
  expect_error(meshed("0.003"), 21, {"about 3.3e+06 triangles", "at most 20000", "make mesh_size_m larger"});
}

TEST(SceneMesh, AlongASlenderBlockTheyCountToo) {
  const std::string sliver = "[0, 10], [1e6, 10], [1e6, 10.1], [0, 10.1]";
  expect_error(with("[3, 2], [3, 4], [0, 4]]",
                    "[3, 2], [3, 4], [0, 4]]\n[[block]]\nname = \"sliver\"\nmaterial = "
                    "\"concrete\"\nmesh_size_m = 30\nvertices_m = [" +
                        sliver + "]"),
               30, {"about 6.7e+04 triangles", "at most 20000"});
}

std::string expecting(const std::string& more) {
  return with("quantity = \"failure_head_m\"\nvalue = 1.0\nof = \"crack\"\n",
              "quantity = \"point_stress_yy_pa\"\nvalue = 1.0\n" + more);
}

TEST(SceneMesh, AFigureIsTakenAtAPointOfABlock) {
  const auto scene = read_text(expecting("of = \"base\"\nat_m = [0, 1]\n"), "s.toml").scene;
  ASSERT_TRUE(scene.expectations[0].at_m.has_value());
  EXPECT_EQ(scene.expectations[0].at_m->y(), 1);
}

TEST(SceneMesh, APointBesideItsBlockIsRefused) {
  expect_error(expecting("of = \"base\"\nat_m = [0, 3]\n"), 56,
               {"at_m (0, 3)", "outside block \"base\"", "move the point"});
}

TEST(SceneMesh, APointOfNoBlockIsRefused) {
  expect_error(expecting("at_m = [0, 1]\n"), 55, {"has at_m and no block", "name the block"});
}

TEST(SceneMesh, ASectionGivesItsSizeToBlocksThatMove) {
  const auto scene = read_text(R"([analysis]
duration_s = 1
[material.m]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[section]
material = "m"
mesh_size_m = 0.7
outline_m = [[0, 0], [4, 0], [4, 4], [0, 4]]
[[region]]
material = "m"
fixed = true
outline_m = [[0, 0], [4, 0], [4, 1], [0, 1]]
[[region]]
material = "m"
mesh_size_m = 0.3
outline_m = [[0, 1], [4, 1], [4, 2], [0, 2]]
)",
                               "s.toml")
                         .scene;
  ASSERT_EQ(scene.blocks.size(), 3U);
  EXPECT_EQ(scene.blocks[0].mesh_size_m, 0);
  EXPECT_EQ(scene.blocks[1].mesh_size_m, 0.3);
  EXPECT_EQ(scene.blocks[2].mesh_size_m, 0.7);
}

}  // namespace
}  // namespace blockweir::scene_mesh_test
