// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic polyclipping
// The walk along a pool's outline against Clipper, in sections at random; sections whose edges touch.
#include <gtest/gtest.h>

#include <cmath>
#include <polyclipping/clipper.hpp>
#include <random>

#include "bridge/scene/polygon.hpp"
#include "fluid/hydrostatic/pool_outline.hpp"
#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {
namespace {

namespace cl = ClipperLib;
const Ring frame = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};

struct Section {
  double area_m2 = 0;
  std::size_t rings = 0;
};

Section by_clipper(FrameSide side, const std::vector<Ring>& obstacles) {
  constexpr double per_m = 1 / outline_unit_m;
  const auto path = [](const Ring& ring) {
    cl::Path p;
    for (const Point& v : ring) p.emplace_back(std::llround(v.x() * per_m), std::llround(v.y() * per_m));
    return p;
  };
  cl::Clipper clipper;
  clipper.AddPath(path(frame), cl::ptSubject, true);
  for (const Ring& obstacle : obstacles) clipper.AddPath(path(obstacle), cl::ptClip, true);
  cl::PolyTree tree;
  clipper.Execute(cl::ctDifference, tree, cl::pftPositive, cl::pftPositive);
  const cl::IntPoint corner = path(frame)[side == FrameSide::left ? 0 : 1];
  for (const cl::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole() || cl::PointInPolygon(corner, node->Contour) == 0) continue;
    Section section{cl::Area(node->Contour), 1 + node->Childs.size()};
    for (const cl::PolyNode* hole : node->Childs) section.area_m2 += cl::Area(hole->Contour);
    section.area_m2 /= per_m * per_m;
    return section;
  }
  return {};
}

Section walked(FrameSide side, const std::vector<Ring>& obstacles) {
  const auto rings = pool_outline(frame, side, obstacles);
  if (!rings) return {};
  Section section{0, rings->size()};
  for (const OutlineRing& ring : *rings) section.area_m2 += scene::signed_area(ring.corner);
  return section;
}

/// A star-shaped polygon, convex or not, in the frame's middle or across its bottom or top.
Ring at_random(std::mt19937& generator, double size) {
  std::uniform_real_distribution<double> unit(0, 1);
  const Point centre(3 + 14 * unit(generator), -1 + 12 * unit(generator));
  const int n = 3 + static_cast<int>(5 * unit(generator));
  const double turn = unit(generator);
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * (i + turn) / n;
    ring.push_back(centre + size * (0.4 + unit(generator)) * Point(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

TEST(PoolOutline, IsWhatClipperFinds) {
  std::mt19937 generator(5);
  std::size_t most_rings = 0;
  for (int section = 0; section < 2000; ++section) {
    std::vector<Ring> obstacles;
    for (int k = section % 40; k >= 0; --k) obstacles.push_back(at_random(generator, section % 3 == 0 ? 1.5 : 0.7));
    for (const FrameSide side : {FrameSide::left, FrameSide::right}) {
      const Section expected = by_clipper(side, obstacles);
      const Section got = walked(side, obstacles);
      ASSERT_NEAR(got.area_m2, expected.area_m2, 1e-9) << section;
      ASSERT_EQ(got.rings, expected.rings) << section;
      most_rings = std::max(most_rings, got.rings);
    }
  }
  EXPECT_GT(most_rings, 5U);
}

/// Grown lines visit reflex corners without room, and cross themselves there.
TEST(PoolOutline, IsWhatClipperFindsOfGrownBlocksWithReflexCorners) {
  std::mt19937 generator(7);
  for (int section = 0; section < 1000; ++section) {
    std::vector<Ring> obstacles;
    for (int k = section % 12; k >= 0; --k) obstacles.push_back(grown(at_random(generator, 1), 0.2 + 0.001 * k));
    const Section expected = by_clipper(FrameSide::left, obstacles);
    const Section got = walked(FrameSide::left, obstacles);
    ASSERT_NEAR(got.area_m2, expected.area_m2, 1e-9) << section;
  }
}

TEST(PoolOutline, WaterWithinARingOfBlocksIsNotThePools) {
  std::vector<Ring> ring = {{{5, 2}, {11, 2}, {11, 3}, {5, 3}},
                            {{5.1, 2.1}, {6, 2.2}, {6, 8}, {5.2, 8}},
                            {{10, 2.3}, {10.9, 2.4}, {10.8, 7.9}, {10.1, 7.8}},
                            {{4.9, 7.1}, {11.1, 7.2}, {11.2, 8.1}, {4.8, 8.2}},
                            {{7, 5}, {8, 5}, {8, 6}, {7, 6}}};
  EXPECT_EQ(walked(FrameSide::left, ring).rings, 2U);
  EXPECT_NEAR(walked(FrameSide::left, ring).area_m2, by_clipper(FrameSide::left, ring).area_m2, 1e-9);
  ring.push_back({{14, 5}, {15, 5}, {15, 6}, {14, 6}});
  EXPECT_EQ(walked(FrameSide::left, ring).rings, 3U);
}

TEST(PoolOutline, SaysNothingWhereEdgesTouchOrThreeMeet) {
  const Ring box = {{5, 2}, {7, 2}, {7, 4}, {5, 4}};
  const auto tells = [&](const Ring& other) { return pool_outline(frame, FrameSide::left, {box, other}).has_value(); };
  EXPECT_TRUE(tells({{7.5, 2}, {9, 2}, {9, 4}, {7.5, 4}}));
  EXPECT_FALSE(tells({{7, 2}, {9, 2}, {9, 4}, {7, 4}}));    // a common face
  EXPECT_FALSE(tells({{7, 3}, {9, 2}, {9, 4}}));            // a corner on a face
  EXPECT_FALSE(tells({{7, 4}, {9, 4.5}, {9, 6}, {7, 6}}));  // a corner on a corner
  // Two diagonals cross in the middle of a face.
  EXPECT_FALSE(pool_outline(frame, FrameSide::left,
                            {box, {{6, 2}, {8, 4}, {9, 4}, {9, 2}}, {{6, 4}, {8, 2}, {9.5, 1}, {9.5, 3}}})
                   .has_value());
}

double wet_length(const std::vector<Ring>& outlines, const WetFaces& wet) {
  double length = 0;
  for (const WetInterval& w : wet.intervals) {
    const Ring& o = outlines[static_cast<std::size_t>(w.block)];
    const auto e = static_cast<std::size_t>(w.edge);
    length += (w.s_to - w.s_from) * (o[(e + 1) % o.size()] - o[e]).norm();
  }
  return length;
}

/// Every joint of a wall is a common face, every corner lies on another block.
TEST(WetFaces, OfAWallAreItsFaceHoweverManyEdgesCoincide) {
  for (const double width : {0.05, 0.0625, 1e-3}) {
    std::vector<Ring> bricks;
    for (int row = 0; row < 12; ++row) {
      for (int k = 0; k < 10; ++k) {
        const double left = std::max(0.0, k - row % 2 * 0.5);
        const double right = k == 9 ? 10 : k + 1 - row % 2 * 0.5;
        bricks.push_back({{left, 0.5 * row}, {right, 0.5 * row}, {right, 0.5 * (row + 1)}, {left, 0.5 * (row + 1)}});
      }
    }
    const WetFaces upstream = wet_faces(bricks, Pool::upstream, 5.75, width);
    EXPECT_NEAR(wet_length(bricks, upstream), 5.75, 1e-9) << width;
    EXPECT_FALSE(upstream.breached);
    EXPECT_NEAR(wet_length(bricks, wet_faces(bricks, Pool::downstream, 2, width)), 2, 1e-9) << width;
    EXPECT_NEAR(wet_length(bricks, wet_faces(bricks, Pool::upstream, 6, width)), 6, 1e-9) << width;
  }
}

/// Gaps of none, one and two of the width that closes, in a random heap on a grid of it.
TEST(WetFaces, GapsJustAsWideAsThoseThatCloseDoClose) {
  constexpr double width = 0.0625;
  int breaches = 0;
  int none = 0;
  std::mt19937 generator(11);
  const auto up_to = [&](int n) { return std::uniform_int_distribution<int>(0, n)(generator); };
  for (int section = 0; section < 300; ++section) {
    std::vector<Ring> blocks = {{{0, -1}, {3, -1}, {3, 0}, {0, 0}}};
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < 8; ++k) {
        if (up_to(3) == 0) continue;
        const Point p(width * (5 * i + up_to(1)), width * (4 * k + up_to(1)));
        blocks.push_back({p, p + Point(4 * width, 0), p + Point(4 * width, 3 * width), p + Point(0, 3 * width)});
      }
    }
    const double level = width * up_to(40);
    const WetFaces wet = wet_faces(blocks, Pool::upstream, level, width);
    const WetFaces wider = wet_faces(blocks, Pool::upstream, level, width * (1 + 1e-9));
    ASSERT_EQ(wet.breached, wider.breached) << section;
    ++(wet.breached ? breaches : none);
  }
  EXPECT_GT(breaches, 10);
  EXPECT_GT(none, 10);
}

TEST(WetFaces, BlocksThatAreTooFarForTheWholeNumbersAreRefused) {
  const std::vector<Ring> blocks = {{{0, 0}, {4, 0}, {4, 10}, {0, 10}}, {{0, -1e6}, {1, -1e6}, {1, 1 - 1e6}}};
  try {
    wet_faces(blocks, Pool::upstream, 7, 0.05);
    FAIL() << "a block at -1000 km";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("1e+06 m from the origin; still water is found up to 524288 m from it"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic
