// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Penalties of a rigid block on level ground that its contacts leave in it by as much after each sweep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "solid/contact/formulation.hpp"
#include "solid/contact/search.hpp"

namespace blockweir::solid::augmented_lagrangian_test {
namespace {

constexpr double round_off_m = 1e-12;

scene::Scene block_on_ground() {
  scene::Scene scene;
  scene.materials.push_back({"rock", 20e9, 0.2, 2000});
  scene.blocks.push_back({.name = "ground", .vertices = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, .fixed = true});
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  scene.analysis.rigid = scene::Rigid::all;
  return scene;
}

class AugmentedLagrangian : public testing::Test {
 protected:
  AugmentedLagrangian() {
    for (const Block& block : parts.blocks) start.emplace_back(block.centroid, Vector6::Zero());
    placement = start;
    ContactSearch(parts, laws, 1, 0.05, 0.05).update(start, contacts);
    for (std::size_t k = 0; k < contacts.size(); ++k) ids.push_back(static_cast<int>(k));
  }

  IslandContacts island() { return {ids, contacts, {}, supports}; }

  void sink(double depth_m) {
    increment[1][1] = -depth_m;
    placement[1] = Placement(parts.blocks[1].centroid, increment[1]);
  }

  std::unique_ptr<Formulation> begun(bool joints_held) {
    auto method = make_augmented_lagrangian(laws, {.force_tolerance_n = 1e-6,
                                                   .position_round_off_m = round_off_m,
                                                   .closed_round_offs = 1,
                                                   .joints_held = joints_held});
    method->begin(trial, {Matrix6::Identity(), 1e9 * Matrix6::Identity()}, {true, false}, island());
    return method;
  }

  /// By how much two sweeps at that depth raise the penalty of the first contact.
  double raised(double depth_m, bool joints_held) {
    for (ContactPoint& c : contacts) static_cast<ContactMemory&>(c) = {.state = ContactState::stick};
    sink(depth_m);
    const auto method = begun(joints_held);
    const double before = contacts[0].penalty;
    for (int sweep = 0; sweep < 2; ++sweep) {
      for (const int k : ids) method->contact(trial, k, contacts[static_cast<std::size_t>(k)]);
      EXPECT_FALSE(method->sweep(island()));
    }
    return contacts[0].penalty / before;
  }

  const scene::Scene scene = block_on_ground();
  const MovingParts parts = make_moving_parts(scene);
  const JointLaws laws{scene};
  std::vector<Placement> start;
  std::vector<Placement> placement;
  std::vector<Vector6> increment{2, Vector6::Zero()};
  const std::vector<Vector6> still{2, Vector6::Zero()};
  std::vector<ContactPoint> contacts;
  std::vector<int> ids;
  std::vector<Support> supports;
  const std::vector<Turn> unturned{2};
  const Trial trial{parts.blocks, start, increment, unturned, placement, still, 0};
};

/// Redundant contacts cannot all close such gaps, and each new penalty asks for a factorization: a slope of 99,936
/// rigid blocks took 28 with its joints held, and takes 3.
TEST_F(AugmentedLagrangian, HeldJointsDoNotRaisePenaltiesForWhatRoundOffMakesOfGaps) {
  EXPECT_EQ(raised(3 * round_off_m, true), 1);
  EXPECT_NEAR(raised(5 * round_off_m, true), 10, 1e-12);
  EXPECT_NEAR(raised(3 * round_off_m, false), 10, 1e-12);
}

/// Penalties of the step before may have been thousands of times as large: what its multipliers and gaps of round-off
/// size add up to now is another force. A wall of 3,014 deformable bricks was out of balance by 5 to 7 kN with each
/// step that was to find it at rest.
TEST_F(AugmentedLagrangian, AStepBeginsWithTheForcesThatTheOneBeforeEndedWith) {
  ASSERT_EQ(contacts.size(), 2U);
  for (const ContactState state : {ContactState::open, ContactState::stick, ContactState::slip}) {
    const double normal = state == ContactState::open ? 0 : 1000;
    const double friction = std::numbers::inv_sqrt3;  // of 30 degrees
    const double shear = normal * (state == ContactState::slip ? -friction : 0.3);
    ContactPoint& c = contacts[0];
    c.state = state;
    c.force = {normal, shear};
    c.multiplier = {4690, 5558};
    c.separation = {0, round_off_m / 3};
    c.gap = c.separation.y();
    const auto method = begun(false);
    method->keep_forces(trial, island());
    method->contact(trial, 0, c);
    EXPECT_NEAR(c.force.x(), normal, 1e-9);
    EXPECT_NEAR(c.force.y(), shear, 1e-9);
    EXPECT_EQ(c.state == ContactState::open, state == ContactState::open);
  }
}

}  // namespace
}  // namespace blockweir::solid::augmented_lagrangian_test
