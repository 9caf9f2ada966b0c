// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene
// The common boundary of two blocks: plane, stepped, partial, absent.
#include <gtest/gtest.h>

#include <cmath>

#include "bridge/scene/joint_trace.hpp"

namespace blockweir::scene_joint_trace_test {
using namespace blockweir::scene;

namespace {

constexpr double tolerance_m = 1e-6;

Block block(std::vector<Point> vertices) {
  return {.vertices = std::move(vertices)};
}

Point on_edge(const Block& b, int edge, double s) {
  const auto e = static_cast<std::size_t>(edge);
  const Point& from = b.vertices[e];
  return from + s * (b.vertices[(e + 1) % b.vertices.size()] - from);
}

/// Both sides' fractions say the same points, and the pieces form one chain.
void expect_consistent(const JointTrace& trace, const Block& a, const Block& b) {
  double length = 0;
  for (std::size_t i = 0; i < trace.pieces.size(); ++i) {
    const TracePiece& p = trace.pieces[i];
    EXPECT_LE((on_edge(a, p.edge_a, p.s_from_a) - p.from_m).norm(), tolerance_m);
    EXPECT_LE((on_edge(a, p.edge_a, p.s_to_a) - p.to_m).norm(), tolerance_m);
    EXPECT_LE((on_edge(b, p.edge_b, p.s_from_b) - p.from_m).norm(), tolerance_m);
    EXPECT_LE((on_edge(b, p.edge_b, p.s_to_b) - p.to_m).norm(), tolerance_m);
    EXPECT_LT((p.s_to_a - p.s_from_a) * (p.s_to_b - p.s_from_b), 0) << "edges that touch run opposite ways";
    if (i > 0) {
      EXPECT_LE((trace.pieces[i - 1].to_m - p.from_m).norm(), tolerance_m);
    }
    length += (p.to_m - p.from_m).norm();
  }
  EXPECT_DOUBLE_EQ(trace.length_m, length);
}

/// The crack of case cracked-dam-upper-stepped and the blocks on either side of it.
const std::vector<Point> stepped{{0, 15},        {2.8, 13.9483}, {3.0, 13.4483},
                                 {5.8, 12.3966}, {6.0, 11.8966}, {10.0829, 10.3631}};
Block above_steps() {
  std::vector<Point> outline = stepped;
  outline.insert(outline.end(), {{4, 22}, {0, 22}});
  return block(outline);
}
Block below_steps() {
  std::vector<Point> outline{{0, 0}, {15.5, 0}};
  outline.insert(outline.end(), stepped.rbegin(), stepped.rend());
  return block(outline);
}

TEST(JointTrace, OfAPlaneCrackIsOnePiece) {
  const Block base = block({{0, 0}, {15.5, 0}, {9.4175, 11.6361}, {0, 15}});
  const Block top = block({{0, 15}, {9.4175, 11.6361}, {4, 22}, {0, 22}});
  const JointTrace trace = trace_joint(base, top, tolerance_m);
  ASSERT_EQ(trace.pieces.size(), 1u);
  expect_consistent(trace, base, top);
  EXPECT_EQ(trace.pieces[0].edge_a, 2);
  EXPECT_EQ(trace.pieces[0].edge_b, 0);
  EXPECT_EQ(trace.pieces[0].s_from_a, 1);
  EXPECT_EQ(trace.pieces[0].s_to_a, 0);
  EXPECT_EQ(trace.pieces[0].s_from_b, 0);
  EXPECT_EQ(trace.pieces[0].s_to_b, 1);
  EXPECT_EQ(trace.mouth(), Point(0, 15));
  EXPECT_EQ(trace.end(), Point(9.4175, 11.6361));
  EXPECT_NEAR(trace.length_m, 10.0, 5e-4);
}

TEST(JointTrace, OfASteppedCrackIsAChainFromItsMouth) {
  const JointTrace trace = trace_joint(below_steps(), above_steps(), tolerance_m);
  ASSERT_EQ(trace.pieces.size(), 5u);
  expect_consistent(trace, below_steps(), above_steps());
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(trace.pieces[i].from_m, stepped[i]);
  EXPECT_EQ(trace.end(), stepped[5]);
}

TEST(JointTrace, IsTheSameLineFromEitherBlock) {
  const JointTrace one = trace_joint(below_steps(), above_steps(), tolerance_m);
  const JointTrace other = trace_joint(above_steps(), below_steps(), tolerance_m);
  ASSERT_EQ(one.pieces.size(), other.pieces.size());
  EXPECT_NEAR(one.length_m, other.length_m, 1e-12);
  for (std::size_t i = 0; i < one.pieces.size(); ++i) {
    EXPECT_EQ(one.pieces[i].from_m, other.pieces[i].from_m);
    EXPECT_EQ(one.pieces[i].edge_a, other.pieces[i].edge_b);
  }
}

TEST(JointTrace, FollowsACrackThatRunsBackUpstream) {
  // A hook: along, down, and back: the pieces' own x does not order them.
  const Block a = block({{0, 0}, {9, 0}, {9, 6}, {4, 6}, {4, 2}, {3, 2}, {3, 3}, {0, 3}});
  const Block b = block({{0, 3}, {3, 3}, {3, 2}, {4, 2}, {4, 6}, {0, 6}});
  const JointTrace trace = trace_joint(a, b, tolerance_m);
  ASSERT_EQ(trace.pieces.size(), 4u);
  expect_consistent(trace, a, b);
  EXPECT_EQ(trace.mouth(), Point(0, 3));
  EXPECT_EQ(trace.end(), Point(4, 6));
  const Block overhang = block({{0, 0}, {3, 0}, {1, 2}, {4, 4}, {0, 4}});
  const Block beak = block({{3, 0}, {6, 0}, {6, 4}, {4, 4}, {1, 2}});
  const JointTrace back = trace_joint(overhang, beak, tolerance_m);
  ASSERT_EQ(back.pieces.size(), 2u);
  expect_consistent(back, overhang, beak);
  EXPECT_EQ(back.mouth(), Point(3, 0));
}

TEST(JointTrace, OfAPartialOverlapIsTheCommonPart) {
  const Block ground = block({{-10, -1}, {10, -1}, {10, 0}, {-10, 0}});
  const Block wall = block({{8, 0}, {12, 0}, {12, 5}, {8, 5}});
  const JointTrace trace = trace_joint(ground, wall, tolerance_m);
  ASSERT_EQ(trace.pieces.size(), 1u);
  expect_consistent(trace, ground, wall);
  EXPECT_EQ(trace.mouth(), Point(8, 0));
  EXPECT_EQ(trace.end(), Point(10, 0));
  EXPECT_EQ(trace.pieces[0].s_from_b, 0);
  EXPECT_EQ(trace.pieces[0].s_to_b, 0.5);
  EXPECT_DOUBLE_EQ(trace.length_m, 2);
}

TEST(JointTrace, OfAVerticalJointBeginsAtItsTop) {
  const Block left = block({{0, 0}, {1, 0}, {1, 2}, {1, 3}, {0, 3}});
  const Block right = block({{1, 0}, {2, 0}, {2, 3}, {1, 3}});
  const JointTrace trace = trace_joint(left, right, tolerance_m);
  ASSERT_EQ(trace.pieces.size(), 2u);
  expect_consistent(trace, left, right);
  EXPECT_EQ(trace.mouth(), Point(1, 3));
  EXPECT_EQ(trace.end(), Point(1, 0));
}

TEST(JointTrace, BridgesGapsUpToTheTolerance) {
  const Block a = block({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(trace_joint(a, block({{0, 1.01}, {1, 1.01}, {1, 2}, {0, 2}}), 0.02).pieces.size(), 1u);
  EXPECT_TRUE(trace_joint(a, block({{0, 1.01}, {1, 1.01}, {1, 2}, {0, 2}}), 0.005).pieces.empty());
}

TEST(JointTrace, IsEmptyWhereBlocksAreApartOrMeetAtAPoint) {
  const Block a = block({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const Block& other : {block({{3, 0}, {4, 0}, {4, 1}, {3, 1}}), block({{1, 1}, {2, 1}, {2, 2}, {1, 2}}),
                             block({{2, 1}, {3, 1}, {3, 2}, {2, 2}})}) {
    const JointTrace trace = trace_joint(a, other, tolerance_m);
    EXPECT_TRUE(trace.pieces.empty());
    EXPECT_EQ(trace.length_m, 0);
  }
}

}  // namespace
}  // namespace blockweir::scene_joint_trace_test
