// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// What still water presses once and no more, in cracks and under structures, and whatever the width of cracks.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/still_water.hpp"

namespace blockweir::hydrostatic::still_water_test {
namespace {

using tests::load_at_rest;
using tests::Resultant;
using tests::resultant;
using tests::scene_of;

/// A dam on ground with water in its base joint, by lumped forces.
TEST(StillWater, LumpedUpliftErrsByOneOverNSquared) {
  auto scene = scene_of({{{-40, -6}, {52, -6}, {52, 0}, {-40, 0}}, {{0, 0}, {12, 0}, {3, 20}, {0, 20}}}, 15);
  scene.joints.push_back({"base", {0, 1}, {}});
  scene.water.nodal_rule = scene::NodalRule::lumped;
  const double push = -9810 * std::pow(15, 3) / 6;
  for (const double tailwater : {0.0, 6.0}) {  // which lies on the sloping face, too
    scene.water.downstream_level_m = scene::TimeTable::constant(tailwater);
    for (const auto law : {scene::Uplift::triangular, scene::Uplift::full}) {
      scene.joints[0].law.uplift = law;
      const double end = law == scene::Uplift::full ? 15 : tailwater;
      const double uplift = 9810 * 12 * 12 * (end / 2 + (15 - end) / 6);
      // The face's foot is at x = 12; along it the pressure is a triangle of (81 + 400)^0.5/20 times the depth.
      const double slant = std::sqrt(481.0) / 20;
      const double arm = tailwater * slant / 3 - 12 * 9 / std::sqrt(481.0);
      const double tail = 9810 * tailwater * tailwater / 2 * slant * arm;
      for (const int n : {10, 100, 400}) {
        scene.water.elements_per_face = n;
        const double moment = resultant(scene, load_at_rest(scene), 1).moment;
        EXPECT_NEAR((moment - push - uplift - tail) / push, 0, 3.0 / (n * n)) << tailwater << ' ' << n;
      }
    }
  }
  EXPECT_NEAR(push + 9810 * 12 * 12 * 15 / 6.0, -1986525, 1e-6);
}

/// A dam whose faces go in and out, and stand over the ground.
TEST(StillWater, ADamWithoutCracksIsPressedTheSameWhateverTheirWidth) {
  auto scene = scene_of({{{-20, -3}, {40, -3}, {40, 0}, {-20, 0}},
                         {{0, 0},
                          {12, 0},
                          {12.61, 8.82},
                          {8.18, 13.91},
                          {6.39, 20},
                          {0.48, 20},
                          {-1.06, 18.67},
                          {1.31, 18.42},
                          {-1.91, 9.56},
                          {0.28, 9.46},
                          {-0.63, 5.92},
                          {-2.59, 1.76},
                          {2.10, 1.70}}},
                        12.33);
  scene.water.downstream_level_m = scene::TimeTable::constant(10.52);
  const Resultant usual = resultant(scene, load_at_rest(scene), 1);
  EXPECT_NEAR(usual.force.x() / (9810 * (12.33 * 12.33 - 10.52 * 10.52) / 2), 1, 1e-12);
  for (const double width : {1e-7, 1e-6, 1e-5, 1e-3, 0.1, 0.5}) {
    scene.water.open_crack_width_m = width;
    const Resultant r = resultant(scene, load_at_rest(scene), 1);
    EXPECT_NEAR((r.force - usual.force).norm() / usual.force.norm(), 0, 1e-9) << width;
    EXPECT_NEAR(r.moment / usual.moment, 1, 1e-9) << width;
  }
  scene.water.open_crack_width_m = 1e-13;
  EXPECT_THROW(HydrostaticModel{scene}, std::invalid_argument);
}

TEST(StillWater, WhatIsBetweenPoolsThatConnectIsPressedOnce) {
  auto scene = scene_of({{{-20, -2}, {30, -2}, {30, 0}, {-20, 0}},
                         {{0, 1}, {0.25, 1}, {0.25, 2}, {0, 2}},
                         {{7.75, 1}, {8, 1}, {8, 2}, {7.75, 2}},
                         {{0, 2}, {8, 2}, {8, 3}, {0, 3}}},
                        3);
  scene.water.downstream_level_m = scene::TimeTable::constant(3);
  const wire::Load still = load_at_rest(scene);
  EXPECT_NEAR(resultant(scene, still, 3).force.y(), 9810 * 7.5, 1e-6);
  EXPECT_FALSE(still.breached);
  scene.water.downstream_level_m = scene::TimeTable::constant(2.5);  // half of the underside has either pressure
  const wire::Load flows = load_at_rest(scene);
  EXPECT_NEAR(resultant(scene, flows, 3).force.y(), 9810 * 3.75 * (1 + 0.5), 1e-6);
  EXPECT_TRUE(flows.breached);
}

TEST(StillWater, ACrackThatOpenWaterHasReachedIsPressedOnce) {
  auto scene = scene_of({{{0, 0}, {6, 0}, {6, 2}, {0, 2}}, {{0, 2}, {6, 2}, {6, 9}, {0, 9}}}, 8);
  scene.joints.push_back({"crack", {0, 1}, {}});
  scene.joints[0].law.uplift = scene::Uplift::full;
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(2);
  motion.displacement.own()[1][1] = 0.5;  // up
  wire::Load load;
  model.advance(motion, 0, load);
  EXPECT_NEAR(resultant(scene, load, 0).force.y(), -9810 * 6 * 6, 1e-6);
  EXPECT_NEAR(resultant(scene, load, 1).force.y(), 9810 * 5.5 * 6, 1e-6);
}

/// Whether water at `level_m` flows over a wall 5 m high whose crest has sunk by `sunk_m`.
bool breached(double level_m, double sunk_m, double tailwater_m = 1) {
  auto scene = scene_of({{{-9, -2}, {9, -2}, {9, 0}, {-9, 0}}, {{0, 0}, {1, 0}, {1, 5}, {0, 5}}}, level_m);
  scene.water.downstream_level_m = scene::TimeTable::constant(tailwater_m);
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(2);
  motion.displacement.own()[1][1] = -sunk_m;
  wire::Load load;
  model.advance(motion, 0, load);
  return load.breached;
}

TEST(StillWater, WaterFlowsOverACrestThatHasSunkBelowIt) {
  EXPECT_FALSE(breached(4.9, 0));
  EXPECT_FALSE(breached(4.9, 0.09));
  EXPECT_FALSE(breached(4.9, 0.12));  // a film, thinner than open water (0.05 m)
  EXPECT_TRUE(breached(4.9, 0.16));
  EXPECT_TRUE(breached(2, 0.16, 4.9));     // the tailwater
  EXPECT_FALSE(breached(4.9, 0.16, 4.9));  // one body of water
  EXPECT_FALSE(breached(5.5, 0.16));       // the scene has it overtopped
}

}  // namespace
}  // namespace blockweir::hydrostatic::still_water_test
