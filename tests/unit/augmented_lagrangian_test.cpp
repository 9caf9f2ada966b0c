// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_contact
// Penalties of a rigid block on level ground that its contacts leave in it by as much after each sweep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "solid/contact/formulation.hpp"
#include "solid/contact/search.hpp"

namespace blockweir::solid {
namespace {

constexpr double round_off_m = 1e-12;

/// By how much two sweeps at that depth raise the penalty of the first contact.
double raised(double depth_m, bool joints_held) {
  scene::Scene scene;
  scene.materials.push_back({"rock", 20e9, 0.2, 2000});
  scene.blocks.push_back({.name = "ground", .vertices = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, .fixed = true});
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  scene.analysis.rigid = scene::Rigid::all;
  const Parts parts = make_parts(scene);
  const JointLaws laws(scene);
  std::vector<Placement> start;
  for (const Block& block : parts.blocks) start.emplace_back(block.centroid, Vector6::Zero());
  std::vector<ContactPoint> contacts;
  ContactSearch(parts, laws, 1, 0.05, 0.05).update(start, contacts);
  std::vector<int> ids;
  for (ContactPoint& c : contacts) {
    c.state = ContactState::stick;
    ids.push_back(static_cast<int>(ids.size()));
  }
  std::vector<Support> supports;
  const Held held{ids, contacts, {}, supports};
  std::vector<Vector6> increment(2, Vector6::Zero());
  increment[1][1] = -depth_m;
  std::vector<Placement> placement = start;
  placement[1] = Placement(parts.blocks[1].centroid, increment[1]);
  const std::vector<Vector6> still(2, Vector6::Zero());
  const Trial trial{parts.blocks, start, increment, placement, still, 0};
  const auto method = make_augmented_lagrangian(laws, {.force_tolerance_n = 1e-6,
                                                       .position_round_off_m = round_off_m,
                                                       .closed_round_offs = 1,
                                                       .joints_held = joints_held});
  method->begin(trial, {Matrix6::Identity(), 1e9 * Matrix6::Identity()}, {true, false}, held);
  const double before = contacts[0].penalty;
  for (int sweep = 0; sweep < 2; ++sweep) {
    for (const int k : ids) method->contact(trial, k, contacts[static_cast<std::size_t>(k)]);
    EXPECT_FALSE(method->sweep(held));
  }
  return contacts[0].penalty / before;
}

/// Redundant contacts cannot all close such gaps, and each new penalty asks for a factorization: a slope of 99,936
/// rigid blocks took 28 with its joints held, and takes 3.
TEST(AugmentedLagrangian, HeldJointsDoNotRaisePenaltiesForWhatRoundOffMakesOfGaps) {
  EXPECT_EQ(raised(3 * round_off_m, true), 1);
  EXPECT_NEAR(raised(5 * round_off_m, true), 10, 1e-12);
  EXPECT_NEAR(raised(3 * round_off_m, false), 10, 1e-12);
}

}  // namespace
}  // namespace blockweir::solid
