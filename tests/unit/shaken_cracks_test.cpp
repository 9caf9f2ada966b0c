// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// Uplift in a joint that opens while the ground shakes: held as it was, or none where the joint is open.
#include "fluid/hydrostatic/shaken_cracks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "bridge/geometry/polygon.hpp"
#include "tests/still_water.hpp"

namespace blockweir::hydrostatic::shaken_cracks_test {
namespace {

constexpr double weight_n_per_m3 = 9810;
constexpr double length_m = 8;
constexpr double level_m = 9;

/// A dam of 10 m on level ground, shaken for a second.
scene::Scene shaken_dam(scene::ShakenUplift uplift) {
  scene::Scene scene =
      tests::scene_of({{{-60, -5}, {60, -5}, {60, 0}, {-60, 0}}, {{0, 0}, {length_m, 0}, {3, 10}, {0, 10}}}, level_m);
  scene.blocks[0].fixed = true;
  scene.default_joint.uplift = scene::Uplift::triangular;
  scene.analysis.gravity_m_per_s2 = 9.81;
  scene.water.uplift_in_shaking = uplift;
  scene.base_motion.emplace();
  scene.base_motion->acceleration_x_m_per_s2 = {.time_s = {0, 0.5, 1}, .value = {0, 2, 0}};
  return scene;
}

/// Upward force of the water under a dam that has turned about its toe.
double force_of(const scene::Scene& scene, HydrostaticModel& model, double turn, double to_s) {
  wire::Motion motion;
  motion.displacement.own().resize(2);
  motion.velocity.own().resize(2);
  const scene::Point toe(length_m, 0);
  const scene::Point arm = toe - geometry::centroid(scene.blocks[1].vertices);
  const scene::Point turned = Eigen::Rotation2Dd(turn) * arm;
  motion.displacement.own()[1] = {(arm - turned).x(), (arm - turned).y(), turn, 0, 0, 0};
  wire::Load load;
  model.advance(motion, to_s, load);
  double force = 0;
  for (std::size_t i = load.cracks_from; i < load.block.size(); ++i) {
    if (load.block[i] != 1) continue;
    force += length_m * (load.s_to[i] - load.s_from[i]) * (load.pressure_from_pa[i] + load.pressure_to_pa[i]) / 2;
  }
  return force;
}

TEST(ShakenCracks, OpenPartsHaveNoUpliftUntilTheGroundRests) {
  constexpr double whole = weight_n_per_m3 * level_m * length_m / 2;
  // Clockwise about the toe by 1.1e-5: beyond 0.91 m from it the joint is open by more than 1e-5 m. Of 20 panels of
  // 0.4 m the last two stay pressed.
  constexpr double turn = -1.1e-5;
  constexpr double pressed = weight_n_per_m3 * level_m * 0.8 / length_m * 0.8 / 2;
  const scene::Scene emptied = shaken_dam(scene::ShakenUplift::zero_where_open);
  HydrostaticModel model(emptied);
  EXPECT_NEAR(force_of(emptied, model, 0, 0.2), whole, 1e-9 * whole);
  EXPECT_NEAR(force_of(emptied, model, turn, 0.4), pressed, 1e-4 * pressed);
  EXPECT_NEAR(force_of(emptied, model, turn, 1.2), whole, 1e-4 * whole)
      << "nothing has moved, but the record has ended";
  const scene::Scene held = shaken_dam(scene::ShakenUplift::held);
  HydrostaticModel usual(held);
  EXPECT_NEAR(force_of(held, usual, turn, 0.4), whole, 1e-4 * whole);
}

TEST(ShakenCracks, TheShakingEndsWithRecordsThatEndAtZero) {
  scene::Scene scene = shaken_dam(scene::ShakenUplift::zero_where_open);
  EXPECT_EQ(shaking_ends_s(scene), 1);
  scene.base_motion->acceleration_y_m_per_s2.sine = scene::Sine{1, 2, 0};
  EXPECT_EQ(shaking_ends_s(scene), std::numeric_limits<double>::infinity());
  scene.base_motion.reset();
  EXPECT_EQ(shaking_ends_s(scene), -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace blockweir::hydrostatic::shaken_cracks_test
