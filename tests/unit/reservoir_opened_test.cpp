// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir
// Water among blocks that have parted: its region may cross itself, and is meshed all the same.
#include <gmock/gmock.h>

#include "bridge/geometry/polygon.hpp"
#include "bridge/geometry/uniform.hpp"
#include "tests/samples.hpp"
#include "tests/unit/reservoir_wall.hpp"

namespace blockweir::reservoir::reservoir_opened_test {
namespace {

using Outline = std::vector<Point>;

/// Three courses of one block or two on rock. Each turns about a corner of its foot on the one below, which it moves
/// with, so that cracks open from nothing; half of them also part, or close with overlap.
hydrostatic::Structure opened(std::uint64_t seed) {
  geometry::Uniform random(seed);
  const auto between = [&](double a, double b) { return a + (b - a) * random(); };
  const double most = std::pow(10, between(-4, -0.5));  // rad
  const double parts = random() < 0.5 ? 0 : most;       // m
  hydrostatic::Structure structure;
  structure.open_crack_width_m = 0.03;
  structure.outlines.push_back({{-30, -5}, {40, -5}, {40, 0}, {-30, 0}});
  Eigen::Isometry2d below = Eigen::Isometry2d::Identity();
  const auto turned = [&](const Point& foot) {
    return Eigen::Translation2d(foot) * Eigen::Rotation2Dd(between(-most, most)) * Eigen::Translation2d(-foot);
  };
  for (int course = 0; course < 3; ++course) {
    const double y = 5.0 * course;
    const double joint = random() < 0.5 ? 6 : between(2, 4);
    below = below * turned({random() < 0.5 ? 0 : 6, y});
    for (const auto& [left, right] : {std::pair(0.0, joint), std::pair(joint, 6.0)}) {
      if (left == right) continue;
      const Eigen::Isometry2d moved = joint == 6 ? below : below * turned({random() < 0.5 ? left : right, y});
      Outline block{{left, y}, {right, y}, {right, y + 5}, {left, y + 5}};
      const Point way(between(-parts, parts), between(-parts, parts));
      for (Point& p : block) p = moved * p + way;
      structure.outlines.push_back(block);
    }
  }
  structure.ground.left = scene::BedCorner{0, 3};
  structure.ground.right = scene::BedCorner{0, 2};
  return structure;
}

double area_of(const WaterMesh& mesh) {
  double area = 0;
  for (const QuadraticTriangle& t : mesh.triangle) {
    const double part = geometry::signed_area(Outline{mesh.node[t[0]], mesh.node[t[1]], mesh.node[t[2]]});
    EXPECT_GT(part, 0);
    area += part;
  }
  return area;
}

/// The mesh of each body has the area of its region.
void is_meshed(const hydrostatic::Structure& structure, double upstream_m, double downstream_m) {
  const Banks banks{structure.outlines};
  const FarEnds ends{{-60, true, {}}, {70, true, {}}};
  hydrostatic::Pools pools;
  const auto water = pools.find(structure, upstream_m, downstream_m, scene::CrestPressure::none);
  for (const hydrostatic::WaterBody& body : water.bodies) {
    WaterMesh mesh;
    ASSERT_NO_THROW(mesh = mesh_water(body, banks, ends, {0.5, 0.02, 0.5}));
    double region = 0;
    for (const Ring& ring : region_of(body, banks, ends)) region += geometry::signed_area(ring);
    EXPECT_NEAR(area_of(mesh) / region, 1, 1e-3);
  }
}

TEST(OpenedBlocks, ABlockThatWaterSurroundsIsNoWater) {
  hydrostatic::Structure structure = opened(0);
  structure.outlines.push_back({{-10, 1}, {-6, 1}, {-6, 4}, {-10, 4}});
  is_meshed(structure, 8, 8);
}

TEST(OpenedBlocks, TheirWaterIsAlwaysMeshed) {
  for (int seed = 0; seed < test::samples(300); ++seed) {
    SCOPED_TRACE(seed);
    geometry::Uniform random(seed);
    const double level = 4 + 10 * random();
    is_meshed(opened(seed), level, random() < 0.5 ? level : 0.5 * level);
  }
}

/// The rows' faces lie in one line but for rounding. What lay between them and that line counted as outside, and with
/// it all of the water.
TEST(OpenedBlocks, WaterBesideRowsThatSlideAsOneIsMeshed) {
  for (int seed = 0; seed < test::samples(150); ++seed) {
    SCOPED_TRACE(seed);
    geometry::Uniform random(static_cast<std::uint64_t>(seed));
    const auto between = [&](double a, double b) { return a + (b - a) * random(); };
    const int rows = 2 + seed % 10;
    const double row_m = between(5, 10) / rows;
    const double slope_m = between(0.5, 3);
    const double slid_m = std::pow(10, between(-5, -1));
    hydrostatic::Structure structure;
    structure.open_crack_width_m = 0.03;
    structure.outlines = {{{-18, -6}, {12, -6}, {12, 0}, {0, 0}, {-18, slope_m}}};
    for (int row = 0; row < rows; ++row) {
      const double y = row * row_m;
      Outline block{{0, y}, {4, y}, {4, y + row_m}, {0, y + row_m}};
      const Eigen::Rotation2Dd turn(between(-1e-12, 1e-12));
      for (Point& p : block) p = turn * p + Point(slid_m * (1 + between(-1e-14, 1e-14)), 0);
      structure.outlines.push_back(block);
    }
    structure.ground.left = scene::BedCorner{0, 4};
    structure.ground.right = scene::BedCorner{0, 2};
    is_meshed(structure, between(slope_m + 0.2, rows * row_m), 0.3);
  }
}

/// Water on both sides meets at the corner, or all but does.
TEST(OpenedBlocks, WaterBesideABlockOnItsCornerIsMeshed) {
  for (int seed = 0; seed < test::samples(300); ++seed) {
    SCOPED_TRACE(seed);
    geometry::Uniform random(seed);
    const double above = (random() < 0.5 ? -1 : 1) * std::pow(10, -9 + 7 * random());
    const Eigen::Rotation2Dd turn(-0.2 - random());
    hydrostatic::Structure structure;
    structure.open_crack_width_m = 0.03;
    structure.outlines = {{{-50, -10}, {80, -10}, {80, 0}, {-50, 0}}, {{-6, 0}, {0, 0}, {0, 7.5}, {-6, 7.5}}};
    for (Point& p : structure.outlines[1]) p = turn * p + Point(6, above);
    structure.ground.left = scene::BedCorner{0, 3};
    structure.ground.right = scene::BedCorner{0, 2};
    is_meshed(structure, 13.5, 13.5);
  }
}

}  // namespace
}  // namespace blockweir::reservoir::reservoir_opened_test
