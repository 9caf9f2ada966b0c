// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Steps that cannot be made end a run with their cause.
#include <gtest/gtest.h>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::refusals_test {
namespace {

TEST(Refusals, StatesThatDoNotSettleAreRefusedForThat) {
  auto scene = empty_scene();
  add(scene, {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, true);
  add(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  scene.contact.max_iterations = 1;
  scene.analysis.kind = scene::AnalysisKind::quasi_static;  // in motion contacts are swept
  scene.default_joint.cohesion_pa = 1;                      // what has a bond to lose is not left to pivoting
  Solid solid(scene);
  try {
    run(solid, 0.01);
    FAIL() << "one solution was enough";
  } catch (const SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("the contact states did not settle at 0 s"), std::string::npos)
        << error.what();
  }
}

/// A cause of its own: no state of contacts is to be found.
TEST(Refusals, ABlockFasterThanAnyStepAllowsIsRefusedForThat) {
  auto scene = empty_scene();
  add(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  scene.blocks[0].initial_velocity_m_per_s = Point(1e12, 0);
  Solid solid(scene);
  try {
    run(solid, 0.01);
    FAIL() << "it went " << solid.states()[0].displacement[0] << " m";
  } catch (const SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("at 0 s blocks move by more than [analysis] max_displacement_ratio"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace blockweir::solid::refusals_test
