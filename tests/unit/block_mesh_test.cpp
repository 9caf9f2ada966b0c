// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_geometry
// Triangles of a block: they fill its outline, and know where they lie on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <vector>

#include "bridge/geometry/mesh.hpp"

namespace blockweir::geometry::block_mesh_test {
namespace {

double twice_area(const Point& a, const Point& b, const Point& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

const std::vector<Point> dam = {{0, 0}, {15.5, 0}, {4, 22}, {0, 22}};
const std::vector<Point> corner = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};  // concave
const std::vector<Point> wedge = {{7.75, 0}, {15.5, 0}, {7.75, 1.75}};

TEST(BlockMesh, TrianglesFillTheOutlineOnce) {
  for (const auto& [outline, area, size] : {std::tuple{dam, 214.5, 1.0}, std::tuple{dam, 214.5, 100.0},
                                            std::tuple{corner, 5.0, 0.3}, std::tuple{wedge, 7.75 * 1.75 / 2, 0.5}}) {
    const Mesh mesh = triangulate(outline, size);
    double sum = 0;
    for (const auto& t : mesh.triangles) {
      std::array<Point, 3> p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = mesh.nodes[static_cast<std::size_t>(t[i])];
      const double twice = twice_area(p[0], p[1], p[2]);
      EXPECT_GT(twice, 0);
      sum += twice / 2;
      for (std::size_t i = 0; i < 3; ++i) EXPECT_LT((p[(i + 1) % 3] - p[i]).norm(), 1.3 * size);
    }
    EXPECT_NEAR(sum, area, 1e-12 * area);
  }
}

TEST(BlockMesh, SidesOnTheOutlineFollowItAllRound) {
  for (const auto& outline : {dam, corner, wedge}) {
    const Mesh mesh = triangulate(outline, 0.6);
    int edge = 0;
    double along = 0;
    for (const BoundarySide& side : mesh.boundary) {
      EXPECT_EQ(side.edge, edge);
      EXPECT_EQ(side.s_from, along);
      const auto& t = mesh.triangles[static_cast<std::size_t>(side.triangle)];
      const Point& a = outline[static_cast<std::size_t>(edge)];
      const Point& b = outline[static_cast<std::size_t>(edge + 1) % outline.size()];
      const Point from = mesh.nodes[static_cast<std::size_t>(t[static_cast<std::size_t>(side.side)])];
      const Point to = mesh.nodes[static_cast<std::size_t>(t[static_cast<std::size_t>((side.side + 1) % 3)])];
      EXPECT_LT((a + side.s_from * (b - a) - from).norm(), 1e-12);
      EXPECT_LT((a + side.s_to * (b - a) - to).norm(), 1e-12);
      along = side.s_to == 1 ? 0 : side.s_to;
      edge += side.s_to == 1;
    }
    EXPECT_EQ(edge, static_cast<int>(outline.size()));
  }
}

TEST(BlockMesh, NoAngleIsBelowTwentyDegreesWhereTheOutlineHasNone) {
  const Mesh mesh = triangulate(dam, 1);
  double least = 180;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto node = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(t[(i + k) % 3])]; };
      const Point u = (node(1) - node(0)).normalized();
      const Point v = (node(2) - node(0)).normalized();
      least = std::min(least, std::acos(u.dot(v)) * 180 / 3.14159265358979);
    }
  }
  EXPECT_GT(least, 20);
}

/// CGAL orders by address: what a scene's text had taken and left of the memory changed the mesh.
TEST(BlockMesh, DoesNotDependOnWhatWasAllocatedBefore) {
  const std::vector<Point> section = {{0, 0}, {24, 0}, {6.5, 26}, {5.5, 31}, {1.5, 31}, {1.5, 18}};
  const Mesh first = triangulate(section, 4);
  for (unsigned seed = 1; seed < 8; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::unique_ptr<char[]>> taken(2000);
    for (auto& part : taken) part = std::make_unique<char[]>(16 + random() % 8000);
    std::shuffle(taken.begin(), taken.end(), random);
    for (auto& part : taken) {
      if (random() % 3 > 0) part.reset();
    }
    const Mesh again = triangulate(section, 4);
    EXPECT_EQ(again.triangles, first.triangles) << seed;
    EXPECT_EQ(again.nodes, first.nodes) << seed;
  }
}

}  // namespace
}  // namespace blockweir::geometry::block_mesh_test
