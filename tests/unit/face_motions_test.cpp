// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir bridge_scene_read
// How points of faces move with what the solid tells.
#include "fluid/reservoir/face_motions.hpp"

#include <gtest/gtest.h>

#include <random>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::reservoir::face_motions_test {
namespace {

using Six = std::array<double, 6>;

scene::Scene scene_of(const std::string& keys) {
  return scene::read_text(R"(analysis = { duration_s = 1 }
water = { upstream_level_m = 3 }
fluid = { model = "reservoir" }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
block = [ { name = "rock", material = "m", fixed = true, vertices_m = [[-9, -5], [20, -5], [20, 0], [-9, 0]] },
          { name = "wall", material = "m", )" +
                              keys +
                              R"( vertices_m = [[0, 0], [8, 0], [7, 10], [1, 11]] } ]
)",
                          "wall")
      .scene;
}

/// x = c + (u, v) + R(r) (I + E) X, as the protocol has it.
std::vector<Point> placed(const std::vector<Point>& outline, const Six& d) {
  const Point c = geometry::centroid(outline);
  const Eigen::Matrix2d F = (Eigen::Matrix2d() << 1 + d[3], d[5] / 2, d[5] / 2, 1 + d[4]).finished();
  std::vector<Point> now;
  for (const Point& x : outline) now.emplace_back(c + Point(d[0], d[1]) + Eigen::Rotation2Dd(d[2]) * (F * (x - c)));
  return now;
}

TEST(FaceMotions, OfABlockThatStrainsAreTheDerivativesOfItsPlaces) {
  const scene::Scene scene = scene_of("");
  const auto& outline = scene.blocks[1].vertices;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 20; ++n) {
    const Six d{any(random), any(random), 3 * any(random), 1e-5 * any(random), 1e-5 * any(random), 1e-5 * any(random)};
    wire::Motion motion;
    motion.displacement = {Six{}, d};
    const FaceMotions moves(scene, motion, {scene.blocks[0].vertices, placed(outline, d)});
    EXPECT_EQ(moves.count(), 4U);
    EXPECT_TRUE(moves({0, 1, 0.5}).unknown.empty());
    const int edge = n % 4;
    const double s = std::abs(any(random));
    const process::PointMotion found = moves({1, edge, s});
    EXPECT_EQ(found.unknown, (std::vector<int>{3, 4, 5, 9, 10, 11}));
    for (std::size_t k = 0; k < 6; ++k) {
      constexpr double h = 1e-5;
      Six more = d;
      Six less = d;
      more[k] += h;
      less[k] -= h;
      const auto at = [&](const Six& six) {
        const auto now = placed(outline, six);
        return Point((1 - s) * now[static_cast<std::size_t>(edge)] + s * now[static_cast<std::size_t>(edge + 1) % 4]);
      };
      const Point rate = (at(more) - at(less)) / (2 * h);
      EXPECT_LT((found.by_unknown.col(static_cast<Eigen::Index>(k)) - rate).norm(), 1e-3) << k;
    }
  }
}

TEST(FaceMotions, OfAMeshAreLinearBetweenItsCorners) {
  const scene::Scene scene = scene_of("mesh_size_m = 5,");
  wire::Motion motion;
  motion.displacement = {Six{}, Six{}};
  motion.face_edge = {{1, 0}, {1, 1}, {1, 1}, {1, 2}, {1, 3}};
  motion.face_s = {0, 0, 0.4, 0, 0};
  const FaceMotions moves(scene, motion, {scene.blocks[0].vertices, scene.blocks[1].vertices});
  EXPECT_EQ(moves.count(), 4U + 5U);
  EXPECT_LT((moves.corners()[2] - Point(7.6, 4)).norm(), 1e-12);
  const auto check = [&](int edge, double s, int from, int to, double way) {
    const process::PointMotion found = moves({1, edge, s});
    EXPECT_EQ(found.unknown, (std::vector<int>{12 + 3 * from, 13 + 3 * from, 12 + 3 * to, 13 + 3 * to}));
    EXPECT_NEAR(found.by_unknown(0, 2), way, 1e-12);
    EXPECT_NEAR(found.by_unknown(1, 1), 1 - way, 1e-12);
    EXPECT_EQ(found.by_unknown(1, 0), 0);
  };
  check(1, 0.1, 1, 2, 0.25);
  check(1, 0.7, 2, 3, 0.5);
  check(3, 0.5, 4, 0, 0.5);  // the last is followed by the first
}

TEST(FaceMotions, OfRigidBlocksAreThreeABlock) {
  const scene::Scene scene = scene_of("rigid = true,");
  wire::Motion motion;
  motion.displacement = {Six{}, Six{}};
  const FaceMotions moves(scene, motion, {scene.blocks[0].vertices, scene.blocks[1].vertices});
  EXPECT_EQ(moves.count(), 2U);
  EXPECT_EQ(moves({1, 3, 0.5}).unknown, (std::vector<int>{3, 4, 5}));
}

}  // namespace
}  // namespace blockweir::reservoir::face_motions_test
