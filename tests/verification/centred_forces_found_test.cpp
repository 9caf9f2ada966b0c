// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step solid_limit bridge_scene_read
// Walls that gravity tilts, without forces of a step before: whether forces hold them is found soon, and as the linear
// program of limit analysis finds it.
#include <gtest/gtest.h>

#include "bridge/statics/loads.hpp"
#include "solid/limit/limit_analysis.hpp"
#include "solid/step/centred_forces.hpp"
#include "tests/collapse_scenes.hpp"
#include "tests/unit/step_sample.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::solid::centred_forces_found_test {
namespace {

TEST(CentredForcesFound, AgreeWithLimitAnalysisAndAreFoundInFewSolutions) {
  const int walls = test::campaign(12);
  int standing = 0;
  for (int k = 0; k < walls; ++k) {
    const unsigned seed = 3001 + static_cast<unsigned>(k + k / 2);  // every third would be a heap
    Sample wall(test::random_fall(seed));
    wall.begin();
    ASSERT_NE(wall.scene.analysis.gravity_tilt_deg, 0) << seed;
    const bool bears = limit::LimitAnalysis(wall.scene).bears(statics::weights_of(wall.scene));
    EXPECT_EQ(CentredForces(wall.step).hold(wall.island()), bears ? Held::yes : Held::no) << seed;
    EXPECT_LE(wall.step.counts.iterations, 25) << seed;
    standing += bears ? 1 : 0;
  }
  EXPECT_GT(standing, 0);
  EXPECT_LT(standing, walls);
}

}  // namespace
}  // namespace blockweir::solid::centred_forces_found_test
