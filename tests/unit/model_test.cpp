// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// What stays as it is while a scene is run.
#include "solid/step/model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "step_sample.hpp"

namespace blockweir::solid::model_test {
namespace {

TEST(Model, MeasuresWhatCanMove) {
  const scene::Scene scene = stones(2);  // from x = 0 to 3
  const Model model(scene);
  EXPECT_DOUBLE_EQ(model.size_m, 1.5);
  EXPECT_DOUBLE_EQ(model.weight_n_per_m, 2 * 25000);
  EXPECT_DOUBLE_EQ(model.typical_width_m(), 1);
  EXPECT_EQ(model.described(), 3U);
}

/// Steps that corners pass over let blocks into each other: none where nothing strains, the ground least of all.
TEST(Model, RigidBlocksOnTheGroundGiveNoWayUnderTheirWeight) {
  scene::Scene scene = stones(2);
  scene.analysis.rigid = scene::Rigid::none;
  Model straining(scene);
  straining.make_rigid({});
  EXPECT_GT(straining.give_under_weight_m, 0);
  scene.analysis.rigid = scene::Rigid::all;
  Model rigid(scene);
  rigid.make_rigid({});
  EXPECT_EQ(rigid.give_under_weight_m, 0);
}

TEST(Model, APseudoStepLeavesInertiaATenThousandthOfTheModulus) {
  const scene::Scene scene = stones();
  const Model model(scene);
  const Block& stone = model.blocks[1];
  const double dt = model.pseudo_step_s();
  EXPECT_NEAR(2 * stone.mass_per_m() / (dt * dt), 1e-4 * stone.stiffness(0, 0) / stone.area, 1);
}

TEST(Model, AStaticAnalysisSettlesUnderTheLoadsOfItsEnd) {
  scene::Scene scene = stones();
  scene.analysis.duration_s = 7;
  EXPECT_EQ(Model(scene).settling_time_s(), 0);
  scene.analysis.kind = scene::AnalysisKind::at_rest;
  const Model at_rest(scene);
  EXPECT_EQ(at_rest.settling_time_s(), 7);
  EXPECT_FALSE(at_rest.scheme.damps);
}

}  // namespace
}  // namespace blockweir::solid::model_test
