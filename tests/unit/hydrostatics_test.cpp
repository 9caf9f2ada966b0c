// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// Force and moment of still water against the formulas, by both nodal rules.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/still_water.hpp"

namespace blockweir::hydrostatic::hydrostatics_test {
namespace {

using tests::load_at_rest;
using tests::Resultant;
using tests::resultant;
using tests::scene_of;

TEST(Hydrostatics, LumpedMomentErrsByOneOverNSquaredAndConsistentIsExact) {
  for (int n = 1; n <= 64; ++n) {
    auto scene = scene_of({{{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, 10);
    scene.water.elements_per_face = n;
    const double moment = -9810 * 1000.0 / 6;
    EXPECT_NEAR(resultant(scene, load_at_rest(scene), 0).moment / moment, 1, 1e-12) << n;
    scene.water.nodal_rule = scene::NodalRule::lumped;
    const Resultant lumped = resultant(scene, load_at_rest(scene), 0);
    EXPECT_NEAR(lumped.moment / moment, 1 - 1.0 / (n * n), 1e-10) << n;
    EXPECT_NEAR(lumped.force.x() / (9810 * 50), 1, 1e-12) << n;
  }
}

TEST(Hydrostatics, ASurfaceInsideAnElementSplitsIt) {
  for (const double level : {9.99, 7.3, 5.0, 0.2}) {
    auto scene = scene_of({{{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, level);
    scene.water.elements_per_face = 7;
    const Resultant r = resultant(scene, load_at_rest(scene), 0);
    EXPECT_NEAR(r.force.x() / (9810 * level * level / 2), 1, 1e-12) << level;
    EXPECT_NEAR(r.moment / (-9810 * level * level * level / 6), 1, 1e-12) << level;
  }
}

TEST(Hydrostatics, SlopingFacesCarryTheWaterAboveThem) {
  for (const double slope : {0.1, 0.2, 0.5, -0.2}) {  // horizontal run of the upstream face over its height
    auto scene = scene_of({{{0, 0}, {8, 0}, {8, 10}, {slope * 10, 10}}}, 9.3);
    scene.water.elements_per_face = 9;
    const Resultant r = resultant(scene, load_at_rest(scene), 0);
    EXPECT_NEAR(r.force.x() / (9810 * 9.3 * 9.3 / 2), 1, 1e-12) << slope;
    EXPECT_NEAR(r.force.y() / (-9810 * 9.3 * 9.3 * slope / 2), 1, 1e-12) << slope;
  }
}

/// The tip of what a block stands on ends at the joint's mouth, in line with the block's face.
TEST(Hydrostatics, ASharpTipBesideAFaceTakesNothingOfItsLoad) {
  for (int angle_deg = 5; angle_deg < 90; angle_deg += 5) {
    const double run = 2 / std::tan(angle_deg * std::numbers::pi / 180);
    for (const double overhang : {0.0, 1.0}) {
      for (const double width_m : {0.01, 0.05, 0.19}) {
        auto scene = scene_of({{{-90, -1}, {90, -1}, {90, 0}, {-90, 0}},
                               {{run, 0}, {run + 30, 0}, {run + 30, 2}, {0, 2}},
                               {{0, 2}, {4, 2}, {4, 6}, {-overhang, 6}}},
                              5);
        scene.water.open_crack_width_m = width_m;
        const Resultant r = resultant(scene, load_at_rest(scene), 2);
        // Under a face that leans over the tip, or goes nearly straight on from its face, the crack's width takes a
        // little.
        const double left_out = overhang > 0 || angle_deg > 80 ? 1e-4 : 1e-12;
        EXPECT_NEAR(r.force.x() / (9810 * 4.5), 1, left_out) << angle_deg << ' ' << overhang << ' ' << width_m;
      }
    }
  }
}

TEST(Hydrostatics, LumpedRuleOnASlopeWithTheSurfaceInsideAnElementKeepsTheForce) {
  auto scene = scene_of({{{0, 0}, {8, 0}, {8, 10}, {2, 10}}}, 7.7);
  scene.water.elements_per_face = 5;
  scene.water.nodal_rule = scene::NodalRule::lumped;
  EXPECT_NEAR(resultant(scene, load_at_rest(scene), 0).force.x() / (9810 * 7.7 * 7.7 / 2), 1, 1e-12);
}

TEST(Hydrostatics, LumpedMomentErrsByTheCubesOfItsElementsOnASlopeWithTheSurfaceInsideOne) {
  // Lumping is the trapezoidal rule of p s: off by sum d^3 / L^3 of the wet length L, 1/N^2 where all d are L/N.
  constexpr double level = 7.3;
  for (const double slope : {0.0, 0.2, -0.3}) {
    for (int n = 1; n <= 64; ++n) {
      auto scene = scene_of({{{0, 0}, {8, 0}, {8, 10}, {slope * 10, 10}}}, level);
      scene.water.elements_per_face = n;
      scene.water.nodal_rule = scene::NodalRule::lumped;
      const double d = 10.0 / n / level;
      const double whole = std::floor(1 / d);
      const double off = whole * std::pow(d, 3) + std::pow(1 - whole * d, 3);
      const double moment = -9810 * std::pow(level, 3) / 6 * (1 + slope * slope);
      EXPECT_NEAR(resultant(scene, load_at_rest(scene), 0).moment / moment, 1 - off, 1e-10) << slope << ' ' << n;
    }
  }
}

TEST(Hydrostatics, ASubmergedBlockLosesTheWeightOfItsWater) {
  auto scene = scene_of({{{-30, -1}, {30, -1}, {30, 0}, {-30, 0}},
                         {{20, 0}, {24, 0}, {24, 12}, {20, 12}},
                         {{-6, 2}, {-3, 1.5}, {-2, 4}, {-5, 5}}},
                        10);
  const Resultant r = resultant(scene, load_at_rest(scene), 2);
  const double area = solid::make_block(scene.blocks[2], scene.materials[0], scene::Plane::strain).area;
  EXPECT_NEAR(r.force.y() / (9810 * area), 1, 1e-12);
  EXPECT_NEAR(r.force.x(), 0, 1e-8);
}

TEST(Hydrostatics, AnAtmosphereOnWetFacesAloneGivesThePapers170KiloPascal) {
  auto scene = scene_of({{{0, 0}, {4, 0}, {4, 7}, {0, 7}}}, 7);
  scene.water.atmosphere = scene::Atmosphere::wet_faces;
  const wire::Load load = load_at_rest(scene);
  double largest = 0;
  for (const double p : load.pressure_to_pa) largest = std::max(largest, p);
  EXPECT_NEAR(largest, 101300 + 9810 * 7, 1e-6);
}

TEST(Hydrostatics, WaterThatPassesAWideGapIsABreach) {
  const auto breached = [](double gap, double level) {
    const auto scene =
        scene_of({{{0, 0}, {4, 0}, {4, 5}, {0, 5}}, {{0, 5 + gap}, {4, 5 + gap}, {4, 12}, {0, 12}}}, level);
    return load_at_rest(scene).breached;
  };
  EXPECT_FALSE(breached(0.01, 10));
  EXPECT_TRUE(breached(0.2, 10));
  EXPECT_FALSE(breached(0.2, 4.9));  // the gap is above the water
}

TEST(Hydrostatics, UpliftLawsGiveTheirShareOfTheMouthPressure) {
  for (const auto& [law, k] : {std::pair{scene::Uplift::triangular, 0.5}, std::pair{scene::Uplift::full, 1.0}}) {
    auto scene = scene_of({{{0, 0}, {6, 0}, {6, 2}, {0, 2}}, {{0, 2}, {6, 2}, {6, 9}, {0, 9}}}, 8);
    scene.joints.push_back({"crack", {0, 1}, {}});
    scene.joints[0].law.uplift = law;
    const Resultant r = resultant(scene, load_at_rest(scene), 1);
    EXPECT_NEAR(r.force.y() / (k * 9810 * 6 * 6), 1, 1e-12);
  }
}

TEST(Hydrostatics, JointsInALineAreOneCrackWhosePressureFallsAlongAllOfIt) {
  auto scene = scene_of(
      {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{2, 0}, {6, 0}, {6, 2}, {2, 2}}, {{0, 2}, {6, 2}, {6, 9}, {0, 9}}}, 8);
  scene.default_joint.uplift = scene::Uplift::triangular;  // the joint between the lower two as well, across the crack
  const wire::Load load = load_at_rest(scene);
  const Resultant r = resultant(scene, load, 2);
  EXPECT_NEAR(r.force.y() / (9810 * 6 * 6 / 2.0), 1, 1e-12);
  const double push = 9810 * 6 * 6 / 2.0;  // on the upstream face, 2 m over its foot at the height of 2 m
  EXPECT_NEAR(r.moment / (9810 * 6 * 6 / 2.0 * 2 - push * 4), 1, 1e-12);
}

TEST(Hydrostatics, SaysHowLongItsPressuresHold) {
  auto scene = scene_of({{{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, 7);
  const auto holds_until = [&](double time_s) {
    HydrostaticModel model(scene);
    wire::Motion motion;
    motion.displacement.own().resize(1);
    wire::Load load;
    model.advance(motion, time_s, load);
    return load.holds_until_s;
  };
  EXPECT_EQ(holds_until(3), std::numeric_limits<double>::infinity());
  scene.water.upstream_level_m = scene::TimeTable{.time_s = {0, 2, 3, 5}, .value = {7, 7, 8, 8}};
  EXPECT_EQ(holds_until(0.5), 2);
  EXPECT_EQ(holds_until(2), 2);
  EXPECT_EQ(holds_until(2.5), 2.5);
  EXPECT_EQ(holds_until(3), std::numeric_limits<double>::infinity());
  scene.water.downstream_level_m = scene::TimeTable{.time_s = {0, 4}, .value = {1, 2}, .stepwise = true};
  EXPECT_EQ(holds_until(3.5), 4);
  EXPECT_EQ(holds_until(4), std::numeric_limits<double>::infinity());
  scene.water.upstream_level_m->sine = scene::Sine{};
  EXPECT_EQ(holds_until(4), 4);
}

TEST(Hydrostatics, NothingIsComputedAgainWhileNothingMoves) {
  const auto scene = scene_of({{{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, 7);
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(1);
  wire::Load first;
  model.advance(motion, 0, first);
  wire::Load second = first;
  model.advance(motion, 1, second);
  EXPECT_EQ(model.report().counts.at("unchanged"), 1);
  EXPECT_EQ(second.pressure_from_pa, first.pressure_from_pa);
  motion.displacement.own()[0][0] = 1e-3;
  model.advance(motion, 2, second);
  EXPECT_EQ(model.updates(), 2);
}

/// The downstream pool stands; then both do; then a block moves.
TEST(HydrostaticModel, KeepsWhatHasNotMovedAndSaysTheSamePressures) {
  scene::Scene skipping = scene_of({{{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, 8);
  skipping.water.upstream_level_m = {.time_s = {0, 1}, .value = {6, 9}};
  skipping.water.downstream_level_m = scene::TimeTable::constant(3);
  scene::Scene thorough = skipping;
  thorough.water.skip_unchanged = false;
  HydrostaticModel keeps(skipping);
  HydrostaticModel repeats(thorough);
  wire::Motion motion;
  motion.displacement.own().resize(1);
  motion.velocity.own().resize(1);
  wire::Load kept;
  wire::Load repeated;
  for (const double t : {0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 2.5}) {
    if (t == 2.5) motion.displacement.own()[0][0] = 0.125;
    keeps.advance(motion, t, kept);
    repeats.advance(motion, t, repeated);
    EXPECT_EQ(kept.block, repeated.block) << t;
    EXPECT_EQ(kept.edge, repeated.edge) << t;
    EXPECT_EQ(kept.s_from, repeated.s_from) << t;
    EXPECT_EQ(kept.s_to, repeated.s_to) << t;
    EXPECT_EQ(kept.pressure_from_pa, repeated.pressure_from_pa) << t;
    EXPECT_EQ(kept.pressure_to_pa, repeated.pressure_to_pa) << t;
    EXPECT_EQ(kept.upstream_level_m, repeated.upstream_level_m) << t;
  }
  const auto lines = keeps.report().skips;
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].rfind("pressures of 2 of 7 windows: neither a level nor a block had moved, saved about", 0), 0U);
  EXPECT_EQ(lines[1].rfind("wet faces of a pool, 3 of 10 times: neither its level nor a block", 0), 0U) << lines[1];
  EXPECT_EQ(repeats.updates(), 7);
  EXPECT_EQ(repeats.report().skips.size(), 1U);
}

/// Ground that a support's motion lifts and moves aside takes its water along; the level is told from it.
TEST(HydrostaticModel, WaterRidesWithTheGround) {
  auto scene = scene_of({{{-20, -1}, {20, -1}, {20, 0}, {-20, 0}}, {{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, 7);
  scene.blocks[0].fixed = true;
  scene.base_motion.emplace().form = scene::BaseForm::support;
  const auto force_x = [&](double up_m) {
    HydrostaticModel model(scene);
    wire::Motion motion;
    motion.displacement.own().assign(2, {0.5, up_m, 0, 0, 0, 0});
    wire::Load load;
    model.advance(motion, 0, load);
    EXPECT_EQ(load.upstream_level_m, 7);
    double force = 0;
    for (std::size_t i = 0; i < load.block.size(); ++i) {
      if (load.block[i] != 1) continue;
      const double length = 10 * std::abs(load.s_to[i] - load.s_from[i]);
      force += length * (load.pressure_from_pa[i] + load.pressure_to_pa[i]) / 2;
    }
    return force;
  };
  EXPECT_NEAR(force_x(-1.3) / (9810 * 7 * 7 / 2.0), 1, 1e-9);
  EXPECT_NEAR(force_x(2) / (9810 * 7 * 7 / 2.0), 1, 1e-9);
  scene.base_motion->form = scene::BaseForm::inertia;
  EXPECT_NEAR(force_x(2) / (9810 * 5 * 5 / 2.0), 1, 1e-9);
}

}  // namespace
}  // namespace blockweir::hydrostatic::hydrostatics_test
