// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// Laws of the water in a joint against values by hand, and cracks whose length follows the level.
#include "fluid/joints/uplift.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bridge/scene/at.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "fluid/joints/crack_length.hpp"

namespace blockweir::joints::uplift_test {
namespace {

using scene::KnownHeads;
using scene::Uplift;

/// Level joint of 40 m at height 0: heads of 60 m and 10 m over it.
const Joint base{.mouth = {600e3, 0}, .end = {100e3, 0}, .length_m = 40, .water_n_per_m3 = 10e3};

TEST(Uplift, ADrainTakesItsShareOfTheHeadAboveTheTailwater) {
  const KnownHeads known{.drain = scene::Drain{.station_m = 8, .efficiency = 0.6}};
  const Profile p = uplift(Uplift::drained, known, base);
  EXPECT_DOUBLE_EQ(p.pressure(0), 600e3);
  EXPECT_DOUBLE_EQ(p.pressure(8), 100e3 + 0.4 * (500e3 - 100e3));  // undrained: 50 m there
  EXPECT_DOUBLE_EQ(p.pressure(40), 100e3);
  EXPECT_DOUBLE_EQ(p.force(), 8 * (600e3 + 260e3) / 2 + 32 * (260e3 + 100e3) / 2);
  EXPECT_DOUBLE_EQ(p.moment_about_mouth(),
                   8 * 8.0 / 6 * (600e3 + 2 * 260e3) + 32 / 6.0 * (260e3 * (2 * 8 + 40) + 100e3 * (8 + 2 * 40)));
}

TEST(Uplift, ADrainThatIsPumpedHasTheHeadOfItsGallery) {
  const KnownHeads known{.drain = scene::Drain{.station_m = 8, .head_m = 4}};
  EXPECT_DOUBLE_EQ(uplift(Uplift::drained, known, base).pressure(8), 40e3);
  const KnownHeads half{.drain = scene::Drain{.station_m = 8, .efficiency = 0.5, .head_m = 4}};
  EXPECT_DOUBLE_EQ(uplift(Uplift::drained, half, base).pressure(8), 10e3 * (4 + 0.5 * (50 - 4)));
  const KnownHeads high{.drain = scene::Drain{.station_m = 8, .head_m = 70}};  // no drain adds head
  EXPECT_DOUBLE_EQ(uplift(Uplift::drained, high, base).pressure(8), 500e3);
}

TEST(Uplift, HeadsOfPiezometersFollowTheReservoirInProportion) {
  const KnownHeads known{.piezometers = {{5, 40}, {20, 20}}, .level_m = 60};
  const Profile read = uplift(Uplift::heads, known, base);
  EXPECT_DOUBLE_EQ(read.pressure(5), 400e3);
  EXPECT_DOUBLE_EQ(read.pressure(20), 200e3);
  Joint lower = base;
  lower.mouth.pressure_pa = 350e3;  // half of the head above the tailwater
  EXPECT_DOUBLE_EQ(uplift(Uplift::heads, known, lower).pressure(5), 250e3);
  EXPECT_DOUBLE_EQ(uplift(Uplift::heads, known, lower).pressure(20), 150e3);
}

/// Readings of a joint that is drained below the tailwater.
TEST(Uplift, HeadsBelowTheTailwaterStayAsRead) {
  const KnownHeads known{.piezometers = {{20, 5}}, .level_m = 40};
  EXPECT_DOUBLE_EQ(uplift(Uplift::heads, known, base).pressure(20), 50e3);
}

/// It bends down to 3 m below the line between its ends.
TEST(Uplift, HeadsAndDrainsOfAJointThatBendsActAtItsElevation) {
  Joint bent = base;
  bent.bends = {{10, -1}, {20, -3}};
  const KnownHeads read{.piezometers = {{15, 40}, {20, 40}}, .level_m = 60};
  EXPECT_DOUBLE_EQ(uplift(Uplift::heads, read, bent).pressure(15), 420e3);
  EXPECT_DOUBLE_EQ(uplift(Uplift::heads, read, bent).pressure(20), 430e3);
  const KnownHeads drained{.drain = scene::Drain{.station_m = 30, .head_m = 0}};
  EXPECT_DOUBLE_EQ(uplift(Uplift::drained, drained, bent).pressure(30), 15e3);
  bent.open_at_mouth_m = 20;
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, {}, bent).pressure(10), 610e3);
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, {}, bent).pressure(20), 630e3);
}

TEST(Uplift, ADrainThatTheCrackHasReachedDrainsNoMore) {
  const KnownHeads known{.drain = scene::Drain{.station_m = 8, .efficiency = 1}};
  Joint open = base;
  open.open_at_mouth_m = 4;
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, known, open).pressure(4), 600e3);
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, known, open).pressure(8), 100e3);
  open.open_at_mouth_m = 10;
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, known, open).pressure(10), 600e3);
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, known, open).pressure(25), 350e3);
}

TEST(Uplift, AnOpenCrackThatDipsHasTheHeadOfItsMouth) {
  Joint dips = {.mouth = {100e3, 10}, .end = {0, 0}, .length_m = 20, .water_n_per_m3 = 10e3, .open_at_mouth_m = 8};
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, {}, dips).pressure(8), 140e3);
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, {}, dips).pressure(14), 70e3);
  const KnownHeads drained{.drain = scene::Drain{.station_m = 14, .efficiency = 0}};
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, drained, dips).pressure(14), 70e3);
  dips.mouth.pressure_pa = 0;  // above the pool
  EXPECT_DOUBLE_EQ(uplift(Uplift::cracked, {}, dips).pressure(8), 0);
}

/// A dam of 80 m under an upright face: crest 5 m, base 60 m, 24 kN/m3.
scene::Scene dam() {
  scene::Scene scene;
  scene.materials.push_back({.name = "concrete", .density_kg_per_m3 = 24e3 / 9.81});
  scene.blocks.push_back({.name = "rock", .vertices = {{-50, -20}, {150, -20}, {150, 0}, {-50, 0}}, .fixed = true});
  scene.blocks.push_back({.name = "dam", .vertices = {{0, 0}, {60, 0}, {5, 80}, {0, 80}}});
  scene.joints.push_back({.name = "base", .between = {0, 1}, .law = {.uplift = Uplift::cracked}});
  scene.fluid = scene::FluidModel::hydrostatic;
  scene.water.elements_per_face = 1;
  return scene;
}

/// Length of its crack at a level, by the pressures on the dam's base.
double crack_length(scene::Scene scene, double level_m) {
  scene.water.upstream_level_m = scene::TimeTable::constant(level_m);
  hydrostatic::HydrostaticModel water(scene);
  wire::Motion drawn;
  drawn.displacement.assign(2, {});
  drawn.velocity.assign(2, {});
  wire::Load load;
  water.advance(drawn, 0, load);
  double open = 0;
  for (std::size_t i = load.cracks_from; i < load.block.size(); ++i) {
    if (load.block[i] != 1) continue;
    const bool full = load.pressure_from_pa[i] == load.pressure_to_pa[i];
    if (full) open = std::max(open, 60 * load.s_to[i]);
  }
  return open;
}

TEST(CrackLength, IsThatOfTheClosedFormForADamOf80Metres) {
  EXPECT_EQ(crack_length(dam(), 76), 0);
  EXPECT_NEAR(crack_length(dam(), 80), 13.323, 5e-4);
  EXPECT_NEAR(crack_length(dam(), 84), 50.27, 5e-3);
  EXPECT_EQ(crack_length(dam(), 88), 60);  // nothing closed can balance it
}

/// A light block on a level base of 10 m between a low pool and a high one, and its mirror image.
TEST(CrackLength, OfABlockThatFloatsIsTheWholeJointUnderTheHigherPool) {
  const auto force = [](double mouth_pa, double end_pa) {
    const Joint joint{.mouth = {mouth_pa, 0}, .end = {end_pa, 0}, .length_m = 10};
    const Thrust thrust{.normal_n_per_m = 490e3, .about_mouth_n = 2450e3, .about_end_n = 2450e3};
    return uplift(Uplift::cracked, {}, opened(Uplift::cracked, {}, joint, thrust)).force();
  };
  EXPECT_DOUBLE_EQ(force(10e3, 95e3), 950e3);
  EXPECT_DOUBLE_EQ(force(95e3, 10e3), 950e3);
  EXPECT_DOUBLE_EQ(force(60e3, 95e3), 950e3);
}

TEST(CrackLength, FollowsLoadsBesideTheWater) {
  scene::Scene held = dam();
  held.point_loads.push_back({.block = 1,
                              .point_m = {0, 80},
                              .force_x_n_per_m = scene::TimeTable::constant(0),
                              .force_y_n_per_m = scene::TimeTable::constant(-2e6)});
  EXPECT_EQ(crack_length(held, 80), 0);
  EXPECT_GT(crack_length(held, 82), 1);
}

}  // namespace
}  // namespace blockweir::joints::uplift_test
