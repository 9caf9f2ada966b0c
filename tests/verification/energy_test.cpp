// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// Energies of motions whose energy is known.
#include "solid/watch/energy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace blockweir::solid::energy_test {
namespace {

scene::Scene one_block() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0, 2500});
  scene.analysis.plane = scene::Plane::stress;
  scene.analysis.max_displacement_ratio = 1;
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {2, 0}, {2, 1}, {0, 1}}});
  return scene;
}

/// Contacts of stones that fall on springs come and go, some while their springs are compressed: what these stored goes
/// with them. Energies of blocks and springs, as they are after each step, are the test's own sum.
TEST(Energy, IsNotMadeByContactsThatAreGone) {
  scene::Scene scene;
  scene.materials.push_back({"rock", 7.48603e+08, 0.2, 2500});
  scene.analysis.step_s = 0.00386937;
  scene.analysis.start = scene::Start::unstressed;
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.max_displacement_ratio = 0.05;
  scene.contact.formulation = scene::ContactFormulation::penalty;
  scene.default_joint.friction_angle_deg = 37.7;
  scene.default_joint.dilation_angle_deg = 7.0926;
  const std::vector<std::vector<Point>> outlines = {{{-1.49720604999, 0.632591668738},
                                                     {-1.49720604999, -4.54415303742},
                                                     {8.98323629993, -4.54415303742},
                                                     {8.98323629993, -3.79555001243}},
                                                    {{0.189027902757, 0.446545092852},
                                                     {0.118838626563, 0.38794283741},
                                                     {0.169738228314, 0.33113797334},
                                                     {0.213184373878, 0.3429594302}},
                                                    {{0.166942900194, 0.13116045523},
                                                     {0.163772684747, 0.141818121558},
                                                     {0.12614306282, 0.185139592482},
                                                     {0.0321778163892, 0.165572616151}}};
  for (const auto& outline : outlines) {
    scene.blocks.push_back({.name = "b" + std::to_string(scene.blocks.size()), .vertices = outline});
  }
  scene.blocks[0].fixed = true;
  Solid solid(scene);
  EnergyWatch watch;
  double lowest = 0;
  double made = 0;
  for (int n = 0; n < 600; ++n) {
    const double dt = scene.analysis.step_s;
    solid.advance(n * dt, (n + 1) * dt, {});
    watch.look(solid);
    double own = energy_of(solid).total();
    for (const ContactPoint& c : solid.contacts()) own += c.stored_j_per_m;
    lowest = n == 0 ? own : std::min(lowest, own);
    made = std::max(made, own - lowest);
  }
  EXPECT_GT(-lowest, 100);        // J per metre: they have fallen by metres
  EXPECT_LE(watch.gain(), 1e-2);  // of all energy; some is made where joints dilate
  EXPECT_LE(made, -1e-1 * lowest);
}

/// A block at rest settles by next to nothing: a thousandth of that is no energy to be warned of.
TEST(Energy, WhatIsMadeOfLittleIsHeldAgainstAFailure) {
  auto scene = one_block();
  scene.analysis.failure_displacement_m = 0.01;
  Solid solid(scene);
  EnergyWatch watch;
  watch.look(solid);
  solid.advance(0, 1e-3, {});           // falls by 10 um, which the work of its weight explains
  scene.analysis.gravity_m_per_s2 = 0;  // told so, the fall has made its energy of nothing
  watch.look(solid);
  EXPECT_GT(watch.gain(), 0);
  EXPECT_LT(watch.gain(), 1e-3);
  EXPECT_EQ(watch.warning(solid), "");
}

TEST(Energy, AFallTurnsWeightIntoMotion) {
  auto scene = one_block();
  scene.blocks[0].initial_velocity_m_per_s = Point(3, 0);
  scene.blocks[0].initial_spin_deg_per_s = 90;
  Solid solid(scene);
  const double mass = 5000;
  const double spin = std::acos(-1.0) / 2;
  EXPECT_NEAR(energy_of(solid).kinetic, mass * 9 / 2 + mass * 5 / 12 * spin * spin / 2, 1e-6);
  EnergyWatch watch;
  const double before = energy_of(solid).total();
  for (int n = 0; n < 50; ++n) {
    solid.advance(n * 0.01, (n + 1) * 0.01, {});
    watch.look(solid);
  }
  EXPECT_NEAR(energy_of(solid).potential, -mass * 9.81 * 9.81 * 0.125, 1e-6);
  EXPECT_NEAR(energy_of(solid).total(), before, 1e-9 * before);
  EXPECT_LT(watch.gain(), 1e-9);
}

TEST(Energy, StrainHoldsTheWorkOfALoad) {
  auto scene = one_block();
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.kind = scene::AnalysisKind::quasi_static;
  for (const double x : {0.0, 2.0}) {
    scene::PointLoad load{.block = 0, .point_m = Point(x, 0.5)};
    load.force_x_n_per_m = scene::TimeTable::constant(x == 0 ? -1e6 : 1e6);
    load.force_y_n_per_m = scene::TimeTable::constant(0);
    scene.point_loads.push_back(load);
  }
  Solid solid(scene);
  EnergyWatch watch;
  watch.look(solid);
  for (int n = 0; n < 5; ++n) solid.advance(n * 0.01, (n + 1) * 0.01, {});
  watch.look(solid);
  EXPECT_NEAR(energy_of(solid).strain, 1e6 * 1e6 * 2 / (2 * 50e9), 1e-6);  // F^2 L/(2 E A)
  EXPECT_NEAR(solid.state().energy.given_j_per_m(), 1e6 * 1e6 * 2 / 50e9, 1e-6);
  EXPECT_EQ(watch.gain(), 0);
}

/// What takes blocks along gives them all that they have, whether they stick on it or are held at a point.
TEST(Energy, AMovingBaseMakesNoneOfNothing) {
  for (const auto integrator : {scene::Integrator::shi, scene::Integrator::generalized_alpha}) {
    for (const bool held : {false, true}) {
      auto scene = one_block();
      scene.analysis.integrator = integrator;
      scene.blocks.push_back({.name = "ground", .vertices = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, .fixed = true});
      scene.base_motion.emplace();
      scene.base_motion->form = scene::BaseForm::support;
      scene.base_motion->acceleration_x_m_per_s2.sine = {4, 2 * std::acos(-1.0), 0};
      if (held) {
        const auto still = scene::TimeTable::constant(0);
        scene.supports.push_back(
            {.block = 0, .point_m = Point(0, 0), .displacement_x_m = still, .displacement_y_m = still});
      }
      Solid solid(scene);
      solid.settle({});
      EnergyWatch watch;
      watch.look(solid);
      for (int n = 0; n < 200; ++n) {
        solid.advance(n * 0.01, (n + 1) * 0.01, {});
        watch.look(solid);
      }
      EXPECT_GT(solid.states()[0].displacement.x(), 0.5);
      EXPECT_LT(watch.gain(), 1e-4) << static_cast<int>(integrator) << (held ? ", held" : "");
    }
  }
}

/// Two runs stand for one that makes energy, as no scene does.
TEST(Energy, WhatIsMadeOfNothingIsWarnedOf) {
  auto scene = one_block();
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.integrator = scene::Integrator::trapezoidal;
  EnergyWatch watch;
  for (const double speed : {10.0, 10.004, 10.01}) {  // 8e-4 and 2e-3 more than at first
    scene.blocks[0].initial_velocity_m_per_s = Point(speed, 0);
    const Solid solid(scene);
    watch.look(solid);
    EXPECT_NEAR(watch.gain(), 1 - 100 / (speed * speed), 1e-12);
    EXPECT_EQ(watch.warning(solid).empty(), speed < 10.01);
  }
  EXPECT_THAT(watch.warning(Solid(scene)),
              testing::AllOf(testing::HasSubstr("has added 500 J per metre, 0.2 % of the run's energy"),
                             testing::HasSubstr("expected at most 0.1 %; shorten [analysis] step_s (now "),
                             testing::HasSubstr("), or take integrator = \"shi\"")));
}

/// Supports swing a block to and fro: the impulses that take it along are theirs.
TEST(Energy, WhatSupportsThatLeadGiveIsNotMadeOfNothing) {
  for (const auto integrator : {scene::Integrator::shi, scene::Integrator::trapezoidal}) {
    auto scene = one_block();
    scene.analysis.integrator = integrator;
    scene.blocks[0].rigid = true;
    scene::TimeTable path = scene::TimeTable::constant(-0.05);
    path.sine = scene::Sine{0.05, 2 * std::acos(-1.0), std::acos(0.0)};
    for (const double x : {0.0, 2.0}) {
      scene.supports.push_back({.block = 0, .point_m = Point(x, 0), .displacement_x_m = path});
      scene.supports.back().displacement_y_m = scene::TimeTable::constant(0);
    }
    Solid solid(scene);
    EnergyWatch watch;
    for (int n = 0; n < 400; ++n) {
      solid.advance(n * 5e-3, (n + 1) * 5e-3, {});
      watch.look(solid);
    }
    EXPECT_LT(watch.gain(), 0.01) << static_cast<int>(integrator);
  }
}

}  // namespace
}  // namespace blockweir::solid::energy_test
