// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Which vertices may touch which edges.
#include "solid/contact/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace blockweir::solid::contact_search_test {
namespace {

/// Two slabs on each other, 0.1 m and 0.2 m thick, the lower one wider.
scene::Scene two_slabs() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "lower", .vertices = {{-1, -0.1}, {2, -0.1}, {2, 0}, {-1, 0}}});
  scene.blocks.push_back({.name = "upper", .vertices = {{0, 0}, {1, 0}, {1, 0.2}, {0, 0.2}}});
  return scene;
}

std::vector<ContactPoint> contacts_within(double reach_m, const scene::Scene& scene = two_slabs(), double size_m = 1) {
  const MovingParts parts = make_moving_parts(scene);
  const JointLaws laws(scene);
  std::vector<Placement> placements;
  for (const Block& block : parts.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
  std::vector<ContactPoint> contacts;
  ContactSearch(parts, laws, size_m, reach_m, reach_m).update(placements, contacts);
  return contacts;
}

TEST(ContactSearch, FindsTheSameContactsWhereTheReachIsLongerThanBlocksAreThick) {
  for (const double reach : {0.05, 0.15, 0.35, 5.0}) {
    const auto contacts = contacts_within(reach);
    ASSERT_EQ(contacts.size(), 2U) << "reach " << reach;
    for (const ContactPoint& c : contacts) {
      EXPECT_EQ(c.vertex_block, 1) << "reach " << reach;
      EXPECT_EQ(c.edge, 2) << "reach " << reach;
      EXPECT_EQ(c.gap, 0) << "reach " << reach;
    }
  }
}

/// Springs have let the slab's corner a little into the wall.
TEST(ContactSearch, KeepsTheFloorOfANotchUnderACornerThatIsPressedIntoItsWall) {
  scene::Scene scene = two_slabs();
  scene.blocks[0].vertices = {{-1, -1}, {2, -1}, {2, 0}, {0, 0}, {0, 1}, {-1, 1}};
  scene.blocks[1].vertices = {{-1e-5, 1e-6}, {1, 1e-6}, {1, 0.5}, {-1e-5, 0.5}};
  const auto contacts = contacts_within(0.1, scene);
  EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(),
                          [](const ContactPoint& c) { return c.vertex_block == 1 && c.vertex == 0 && c.edge == 2; }));
}

/// Contacts of two outlines that do not touch.
std::vector<ContactPoint> contacts_between(const std::vector<Point>& one, const std::vector<Point>& other,
                                           double size_m = 1) {
  scene::Scene scene = two_slabs();
  scene.blocks[0].vertices = one;
  scene.blocks[1].vertices = other;
  return contacts_within(0.1, scene, size_m);
}

/// It would be through before it has "entered" by the end of a step.
TEST(ContactSearch, SeesACornerThatComesToAnEdgeNearItsEnd) {
  const auto contacts = contacts_between({{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}, {{-1, 0.2}, {0.007, 0.015}, {-0.5, 1}});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].vertex_block, 0);
  EXPECT_NEAR(contacts[0].gap, 0.016, 0.001);
}

TEST(ContactSearch, SeesAcuteCornersOfWhichNeitherFacesAnEdge) {
  const auto contacts = contacts_between({{0.5, 0.02}, {1, 0}, {0.7, 0.6}}, {{1.006, 0}, {1.7, 0.1}, {1.02, 0.5}});
  EXPECT_EQ(contacts.size(), 1U);
}

/// Two tips on a floor, one 4 um up the other's face: that one lies below it, behind the line of its upper edge, and
/// would have been pushed out of what it is not in.
TEST(ContactSearch, ATipBelowAnAcuteCornerIsInNothing) {
  const std::vector<Point> up{{3.476667424606, 0}, {4.283967922881, 3.964282e-6}, {4.042322402431, 0.459351771125}};
  const std::vector<Point> below{{5, 0}, {4.820495692035, 0.298590631398}, {4.283960799498, 0}};
  const auto contacts = contacts_between(up, below, 5);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].vertex_block, 0);
  EXPECT_NEAR(contacts[0].gap, 0, 1e-9);
}

TEST(ContactSearch, LetsCornersPassThatSlideOverEachOther) {
  EXPECT_TRUE(
      contacts_between({{-1, 0}, {-1e-3, 0}, {-1e-3, 0.5}, {-1, 0.5}}, {{0, -0.5}, {1, -0.5}, {1, 0}, {0, 0}}).empty());
}

TEST(ContactSearch, LooksFartherOnceBlocksHaveMovedFarther) {
  const scene::Scene scene = two_slabs();
  const MovingParts parts = make_moving_parts(scene);
  const JointLaws laws(scene);
  std::vector<Placement> placements;
  for (const Block& block : parts.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
  Vector6 up = Vector6::Zero();
  up[1] = 0.02;
  placements[1] = Placement(parts.blocks[1].centroid, up);
  ContactSearch search(parts, laws, 1, 0.01, 0.1);
  std::vector<ContactPoint> contacts;
  search.update(placements, contacts);
  EXPECT_TRUE(contacts.empty());
  EXPECT_TRUE(search.covers(0.003));
  EXPECT_FALSE(search.covers(0.02));
  search.update(placements, contacts);
  EXPECT_EQ(contacts.size(), 2U);
  EXPECT_TRUE(search.covers(0.02));
}

/// With one of them alone the other end would turn in, unseen.
TEST(ContactSearch, KeepsBothEndsOfAShortOverlapWhileTheFacesAreFarFromEachOther) {
  const std::vector<Point> lower = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
  const auto over_its_corner = [&](double turned) {
    return contacts_between(lower, {{-0.005, 0.01}, {1, 0.01 + turned}, {0.5, 1}}).size();
  };
  EXPECT_EQ(over_its_corner(0), 2U);
  EXPECT_EQ(over_its_corner(0.1), 2U);
  EXPECT_EQ(over_its_corner(0.2), 1U);
}

/// Two blocks may turn by 0.05 rad each.
TEST(ContactSearch, SeesAVertexWhoseFaceMayTurnOntoAnEdge) {
  const auto on_a_corner = [](double turned) {
    return contacts_between({{-1, -1}, {1, -1}, {1, 0}, {-1, 0}}, {{0, 0}, {0.5, 0.5 * turned}, {0.2, 1}}).size();
  };
  EXPECT_EQ(on_a_corner(0.09), 2U);
  EXPECT_EQ(on_a_corner(0.11), 1U);
}

/// A dam on a base that rises to its toe, with level ground beyond: so far pushed that its toe has left the base, it
/// stands on the ground's corner, not on the level ground that the toe has come to.
TEST(ContactSearch, AToeThatIsPushedPastTheEndOfItsBaseStaysBonded) {
  scene::Scene scene = two_slabs();
  scene.blocks[0].vertices = {{-1, -1}, {2, -1}, {2, 0.04}, {1, 0.04}, {0, 0}, {-1, 0}};
  scene.blocks[1].vertices = {{0, 0}, {1, 0.04}, {0.5, 1}, {0, 1}};
  const MovingParts parts = make_moving_parts(scene);
  const JointLaws laws(scene);
  std::vector<Placement> placements;
  for (const Block& block : parts.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
  std::vector<ContactPoint> contacts;
  ContactSearch search(parts, laws, 1, 0.1, 0.1);
  search.update(placements, contacts);
  for (ContactPoint& c : contacts) {
    c.state = ContactState::stick;
    c.bond = c.bond_length = 0.5;
  }
  Vector6 pushed = Vector6::Zero();
  pushed.head<2>() = 1e-5 * Point(1, 0.03);
  placements[1] = Placement(parts.blocks[1].centroid, pushed);
  search.update(placements, contacts);
  const auto bonded = [](const ContactPoint& c) {
    return c.bonded() && c.state == ContactState::stick && c.length > 0;
  };
  EXPECT_EQ(std::count_if(contacts.begin(), contacts.end(), bonded), 2);
}

/// Two corners of which neither faces the other's edges, as their search sees them.
class PassingCorners : public testing::Test {
 protected:
  explicit PassingCorners(const std::vector<Point>& left = {{-1, -0.5}, {0, 0}, {-1, 0.5}},
                          const std::vector<Point>& right = {{0.01, 0.004}, {1, -0.5}, {1, 0.5}})
      : scene_(corners(left, right)) {}
  std::size_t contacts() {
    search_.update(placements_, contacts_);
    return contacts_.size();
  }
  void press() {
    for (ContactPoint& c : contacts_) c.state = ContactState::stick;
  }
  /// Of the edge that the first contact presses on, to its outside.
  [[nodiscard]] Point normal() const {
    const ContactPoint& c = contacts_.front();
    const Point t = (c.edge_to - c.edge_from).normalized();
    return (c.edge_block == 0 ? 1 : -1) * Point(t.y(), -t.x());
  }
  /// After a step that takes the right one so far.
  bool entered(double x_m, double y_m) {
    std::vector<Placement> after = placements_;
    Vector6 moved = Vector6::Zero();
    moved.head<2>() << x_m, y_m;
    after[1] = Placement(parts_.blocks[1].centroid, moved);
    const bool has = search_.entered(after, contacts_, 0);
    if (!has) search_.forget_step();
    return has;
  }

 private:
  static scene::Scene corners(const std::vector<Point>& left, const std::vector<Point>& right) {
    scene::Scene scene = two_slabs();
    scene.blocks[0].vertices = left;
    scene.blocks[1].vertices = right;
    return scene;
  }
  scene::Scene scene_;
  MovingParts parts_ = make_moving_parts(scene_);
  JointLaws laws_{scene_};
  ContactSearch search_{parts_, laws_, 1, 0.1, 0.1};
  std::vector<Placement> placements_{{parts_.blocks[0].centroid, Vector6::Zero()},
                                     {parts_.blocks[1].centroid, Vector6::Zero()}};
  std::vector<ContactPoint> contacts_;
};

TEST_F(PassingCorners, AreNoContactWhereTheyPass) {
  EXPECT_EQ(contacts(), 0U);
  EXPECT_FALSE(entered(-0.02, 0.01));
  EXPECT_EQ(contacts(), 0U);
}

TEST_F(PassingCorners, AreOneOnceAStepHasTakenOneIntoTheOther) {
  EXPECT_EQ(contacts(), 0U);
  EXPECT_TRUE(entered(-0.02, 0));
  EXPECT_GE(contacts(), 1U) << "when the step is done again";
  EXPECT_FALSE(entered(-0.02, 0)) << "it is held now";
  EXPECT_EQ(contacts(), 0U) << "in the step that follows";
}

/// Two planes that cross askew: the left block, above one of them, and the right one, below it, touch in the crossing.
class CornersOfCrossingPlanes : public PassingCorners {
 protected:
  explicit CornersOfCrossingPlanes(const Point& shift = Point(0, 0))
      : PassingCorners(moved({{0, 0}, {-0.6, -0.3}, {2.04, -2.28}, {2.4, -1.8}}, shift),
                       moved({{0, 0}, {0.6, 0.3}, {-1.24, 1.68}, {-1.6, 1.2}}, shift)) {}
  static std::vector<Point> moved(std::vector<Point> outline, const Point& by) {
    for (Point& p : outline) p += by;
    return outline;
  }
};

TEST_F(CornersOfCrossingPlanes, PassAlongEither) {
  EXPECT_EQ(contacts(), 0U);
  EXPECT_FALSE(entered(0.008, -0.006));
  EXPECT_FALSE(entered(-0.006, -0.003));
  EXPECT_EQ(contacts(), 0U);
}

TEST_F(CornersOfCrossingPlanes, PressOnTheEdgeThatAStepHasLeftLeastBehind) {
  EXPECT_EQ(contacts(), 0U);
  EXPECT_TRUE(entered(0.008 - 1e-4, -0.006 - 1e-3));
  ASSERT_EQ(contacts(), 1U) << "when the step is done again";
  EXPECT_FALSE(entered(0.008 - 1e-4, -0.006 - 1e-3)) << "it is held now";
  EXPECT_GT(normal().dot(Point(0.6, 0.8)), 0.999) << "of the plane that it slides on";
}

/// Round-off has moved one corner by some 1e-15 m.
class CornersOfCrossingPlanesElsewhere : public CornersOfCrossingPlanes {
 protected:
  CornersOfCrossingPlanesElsewhere() : CornersOfCrossingPlanes(Point(10.1, 7.3)) {}
};

TEST_F(CornersOfCrossingPlanesElsewhere, PassAllTheSame) {
  EXPECT_EQ(contacts(), 0U);
  EXPECT_FALSE(entered(0.008, -0.006));
  EXPECT_FALSE(entered(-0.006, -0.003));
}

/// A heel that has slid past the corner of the ground, down its dipping base.
class HeelPastACorner : public PassingCorners {
 protected:
  HeelPastACorner()
      : PassingCorners({{-2, -1}, {2, -1}, {2, -0.1}, {0, 0}, {-2, 0}},
                       {{1e-6, -5e-8}, {1, -0.05}, {1, 0.5}, {1e-6, 0.5}}) {}
};

TEST_F(HeelPastACorner, IsNotHeldByTheFaceBehindItHoweverFarItsSpringLetsItIn) {
  EXPECT_EQ(contacts(), 2U);
  press();
  EXPECT_FALSE(entered(0, -1e-5));
  EXPECT_EQ(contacts(), 2U);
}

/// Acute corners that a step takes through each other: neither is in the other's block at its end.
class CrossingTips : public PassingCorners {
 protected:
  CrossingTips()
      : PassingCorners({{-1, -0.38}, {0, 0}, {-1, 0.2}}, {{0.0058, 0.0048}, {0.7558, 0.6648}, {-0.0492, 1.0048}}) {}
};

TEST_F(CrossingTips, AreOneOnceAStepHasTakenOneThroughTheOther) {
  EXPECT_EQ(contacts(), 0U);
  EXPECT_TRUE(entered(-0.01, -0.0082));
  EXPECT_GE(contacts(), 1U) << "when the step is done again";
}

}  // namespace
}  // namespace blockweir::solid::contact_search_test
