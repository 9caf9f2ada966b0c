// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Slopes of jointed rock that move from the start: blocks with one strain lock each other while their joints are held,
// by forces many times the weight, and these must not throw them.
#include <gtest/gtest.h>

#include "tests/verification/campaign.hpp"
#include "tests/verification/jointed_abutment.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::moving_slopes_test {
namespace {

scene::Scene slope(test::Random& random) {
  const test::JointSet foliation{random.between(-45, -35), random.between(3.5, 5), random.between(45, 55)};
  const test::JointSet cross{random.between(55, 65), random.between(4, 6), random.between(50, 58)};
  return test::jointed_abutment(foliation, cross);
}

TEST(MovingSlopes, FallNoFartherThanWeightTakesThem) {
  for (int seed = 2; seed <= 2 * test::campaign(2); seed += 2) {
    test::Random random(static_cast<unsigned>(seed));
    Solid solid(slope(random));
    solid.settle({});
    const double settled_m = solid.largest_displacement_m();
    const double dt = solid.scene().analysis.step_s;
    run(solid, 2 * dt);
    EXPECT_LT(solid.largest_displacement_m() - settled_m, 9.81 * std::pow(2 * dt, 2)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace blockweir::solid::moving_slopes_test
