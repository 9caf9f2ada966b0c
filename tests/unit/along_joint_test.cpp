// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// The way along a joint goes round its bends, whatever the order and direction of its parts.
#include "bridge/picture/along_joint.hpp"

#include <gtest/gtest.h>

namespace blockweir::test::along_joint_test {
namespace {

using picture::JointPoint;

/// 6 m down, 8 m along, and beyond a gallery of 1 m another 3 m; values are the way.
void expect_ways(const std::vector<JointPoint>& points) {
  const auto along = picture::along_joint(points);
  ASSERT_EQ(along.size(), points.size());
  double before_m = 0;
  for (const auto& p : along) {
    EXPECT_NEAR(p.way_m, p.value, 2e-4);
    EXPECT_GE(p.way_m, before_m);
    before_m = p.way_m;
  }
}

TEST(AlongJoint, GoesRoundBendsAndOverGaps) {
  const std::vector<JointPoint> down = {{{0, 0}, 0}, {{0, -3}, 3}, {{0, -6}, 6}};
  const std::vector<JointPoint> base = {{{0.0001, -6}, 6}, {{8, -6}, 14}};
  const std::vector<JointPoint> beyond = {{{9, -6}, 15}, {{12, -6}, 18}};
  const auto all = [](std::vector<JointPoint> list, const std::vector<JointPoint>& b,
                      const std::vector<JointPoint>& c) {
    list.insert(list.end(), b.begin(), b.end());
    list.insert(list.end(), c.begin(), c.end());
    return list;
  };
  const auto turned = [](const std::vector<JointPoint>& list) {
    return std::vector<JointPoint>(list.rbegin(), list.rend());
  };
  expect_ways(all(down, base, beyond));
  expect_ways(all(beyond, base, down));
  expect_ways(all(turned(base), turned(down), beyond));
  expect_ways(all(base, turned(beyond), turned(down)));
}

TEST(AlongJoint, OfNothingIsNothing) {
  EXPECT_TRUE(picture::along_joint({}).empty());
  EXPECT_EQ(picture::along_joint({{{2, 3}, 7}}).front().way_m, 0);
}

}  // namespace
}  // namespace blockweir::test::along_joint_test
