// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Tips of blocks that strain may be in each other by a little: the search sees them until they have parted.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "solid/contact/search.hpp"

namespace blockweir::solid::passing_tips_test {
namespace {

scene::Scene two_tips() {
  scene::Scene scene;
  scene.materials.push_back({"stone", 1e9, 0.2, 2500});
  scene.blocks.push_back({.name = "left", .vertices = {{0, 0}, {0.448567, 0.092044}, {0.266009, 0.278708}}});
  scene.blocks.push_back(
      {.name = "right", .vertices = {{-0.112974, 0.282186}, {0.000108, -0.000039}, {0.224965, 0.277375}}});
  return scene;
}

/// The first step leaves one tip behind the other's face by more than 1e-3 of the width, beside the face's end. The
/// search after it lost both, and nothing stopped the second.
TEST(PassingTips, AreSeenInTheStepThatFollowsOneThatHasTakenThemPastEachOther) {
  const scene::Scene scene = two_tips();
  const MovingParts parts = make_moving_parts(scene);
  const JointLaws laws(scene);
  const auto placed = [&](double x_m, double y_m) {
    std::vector<Placement> placements;
    for (const Block& block : parts.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
    Vector6 moved = Vector6::Zero();
    moved.head<2>() << x_m, y_m;
    placements[1] = Placement(parts.blocks[1].centroid, moved);
    return placements;
  };
  std::vector<ContactPoint> contacts;
  ContactSearch search(parts, laws, 1, 0.02, 0.1);
  search.begin_motion(5.4e-4);
  search.update(placed(0, 0), contacts);
  EXPECT_TRUE(contacts.empty());
  EXPECT_FALSE(search.entered(placed(3.9e-4, -1.4e-4), contacts, 0)) << "by so much they may";
  search.forget_step();
  search.update(placed(3.9e-4, -1.4e-4), contacts);
  EXPECT_TRUE(!contacts.empty() || search.entered(placed(1.2e-3, -4e-4), contacts, 0));
}

/// A face lies askew on another's far corner, and its tip is in the near one by as much as it may. As it sinks in
/// deeper it comes out beside the face: the contact at the far corner does not hold it, though that is one of the
/// face's ends.
TEST(PassingTips, AreNotHeldByAContactAtTheOtherEndOfTheirFaces) {
  scene::Scene scene = two_tips();
  scene.blocks[0].vertices = {{-0.2, -1}, {0.5, -1}, {0, 0}, {-0.3, 0}};
  scene.blocks[1].vertices = {{-0.6, 0.00319}, {0.001, -0.0032}, {-0.1525, 0.2659}};
  const MovingParts parts = make_moving_parts(scene);
  const JointLaws laws(scene);
  const Point far_corner(-0.3, 0);
  const auto turned = [&](double slid_m, double angle) {
    std::vector<Placement> placements;
    for (const Block& block : parts.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
    const Point& centre = parts.blocks[1].centroid;
    Vector6 moved = Vector6::Zero();
    moved[2] = angle;
    moved.head<2>() = far_corner + Point(slid_m, 0) - centre - Eigen::Rotation2Dd(angle) * (far_corner - centre);
    placements[1] = Placement(centre, moved);
    return placements;
  };
  std::vector<ContactPoint> contacts;
  ContactSearch search(parts, laws, 1, 0.02, 0.1);
  search.begin_motion(4.6e-3);
  search.update(turned(0, 0), contacts);
  EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [](const ContactPoint& c) {
    return c.vertex_block == 0 && c.vertex == 3;
  })) << "at the far corner";
  EXPECT_TRUE(search.entered(turned(0.002, -0.00785), contacts, 0));
}

}  // namespace
}  // namespace blockweir::solid::passing_tips_test
