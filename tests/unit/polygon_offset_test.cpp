// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_joints
// Closed lines that grow, and come back to where they were.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/geometry/polygon.hpp"
#include "fluid/joints/polygon_offset.hpp"

namespace blockweir::joints::polygon_offset_test {
namespace {

double distance_to(const Ring& outline, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point span = outline[(i + 1) % outline.size()] - a;
    const double s = std::clamp((p - a).dot(span) / span.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + s * span - p).norm());
  }
  return least;
}

/// Corners of all kinds: blunt, right, sharp and reflex.
const std::vector<Ring> outlines = {{{0, 0}, {4, 0}, {4, 2}, {0, 2}},
                                    {{0, 0}, {10, 0}, {0, 1}},
                                    {{-3, 0}, {0, -2}, {3, 0}, {2, 3}, {-2, 3}},
                                    {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 1}, {0, 1}},
                                    {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 3.9}, {3.8, 3.7}, {3.8, 1}, {0, 1}}};

TEST(Sideways, ALineThatHasGrownIsNowhereNearerAndAtNoCornerMuchFarther) {
  constexpr double farthest = 20 * std::numbers::pi / 180;  // half of the sharpest corner that is mitred
  for (const Ring& outline : outlines) {
    const Ring line = grown(outline, 0.25);
    for (std::size_t i = 0; i < line.size(); ++i) {
      for (const double s : {0.0, 0.25, 0.5, 0.75}) {
        const Point p = line[i] + s * (line[(i + 1) % line.size()] - line[i]);
        const bool in_a_loop = outline.size() > 6 && std::abs(p.x() - 3.9) < 0.5;  // its edges are short
        if (!in_a_loop) EXPECT_GE(distance_to(outline, p), 0.25 - 1e-12) << p;
        EXPECT_LE(distance_to(outline, p), 0.25 / std::sin(farthest) + 1e-12) << p;
      }
    }
  }
}

TEST(Sideways, WhatHasGrownMovesBackOntoTheEdges) {
  for (const Ring& outline : {outlines[0], outlines[1], outlines[2], outlines[3]}) {
    const Ring line = grown(outline, 0.25);
    const std::vector<Piece> pieces = moved_right(line, std::vector<double>(line.size(), -0.25));
    ASSERT_EQ(pieces.size(), outline.size());  // what was cut square at sharp corners has turned round
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t e = 0; e < outline.size(); ++e) {
        const Point& to = outline[(e + 1) % outline.size()];
        best = std::min(best, (pieces[i].from - outline[e]).norm() + (pieces[i].to - to).norm());
      }
      EXPECT_LT(best, 1e-12);
    }
  }
}

TEST(Sideways, EdgesThatMoveByDifferentWaysMeetWhereTheirLinesCross) {
  const Ring water = {{0, 0}, {3, 0}, {4, 2}, {0, 2}};
  const std::vector<Piece> pieces = moved_right(water, {0.5, 0.5, -0.5, 0});
  ASSERT_EQ(pieces.size(), 4U);
  EXPECT_NEAR((pieces[0].from - Point(0, -0.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((pieces[0].to - pieces[1].from).norm(), 0, 1e-12);
  EXPECT_NEAR(pieces[1].to.y(), 1.5, 1e-12);
  EXPECT_NEAR((pieces[2].to - Point(0, 1.5)).norm(), 0, 1e-12);
}

TEST(Sideways, LinesThatHardlyCrossAreNotFollowedFar) {
  const Ring wedge = {{0, 0}, {10, 0}, {10, 1e-3}, {0, 1e-2}};
  for (const Piece& piece : moved_right(wedge, {0.1, 0.1, 0.1, 0.1})) {
    EXPECT_LT(piece.from.cwiseAbs().maxCoeff(), 12);
    EXPECT_LT(piece.to.cwiseAbs().maxCoeff(), 12);
  }
  EXPECT_TRUE(moved_right({}, {}).empty());
}

}  // namespace
}  // namespace blockweir::joints::polygon_offset_test
