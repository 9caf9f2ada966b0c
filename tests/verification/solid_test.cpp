// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// The solid against closed answers: rotation, orders of the integrators, first acceleration, supports, cohesion.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "bridge/geometry/polygon.hpp"
#include "solid/solve/sparse_solvers.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::solid_test {
namespace {

TEST(Solid, AThousandTurnsKeepAreaAndAngularMomentum) {
  auto scene = empty_scene();
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.step_s = 1e-3;
  scene.analysis.max_displacement_ratio = 1;
  add(scene, {{0, 0}, {3, 0}, {2, 1}, {0, 1.5}});
  scene.blocks[0].initial_spin_deg_per_s = 3600;
  Solid solid(scene);
  run(solid, 100);
  EXPECT_NEAR(solid.states()[0].displacement[2] / (2 * std::numbers::pi), 1000, 1e-6);
  std::vector<Point> outline;
  for (const Point& X : solid.blocks()[0].vertices) outline.push_back(solid.placements()[0].position(X));
  EXPECT_NEAR(geometry::signed_area(outline) / solid.blocks()[0].area, 1, 1e-12);
  const Vector6 momentum = solid.blocks()[0].inertia * solid.states()[0].velocity;
  EXPECT_NEAR(momentum[2] / (solid.blocks()[0].inertia.of_turn() * 20 * std::numbers::pi), 1, 1e-10);
}

/// Error of the position of a falling block under a force that grows with time, after 1 s: cubic in time.
double error_of(scene::Integrator integrator, double dt) {
  auto scene = empty_scene();
  scene.analysis.integrator = integrator;
  scene.analysis.step_s = dt;
  scene.analysis.max_displacement_ratio = 100;
  scene.analysis.gravity_m_per_s2 = 0;
  add(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  scene::PointLoad load;
  load.point_m = Point(0.5, 0.5);
  load.force_x_n_per_m = {.time_s = {0, 1}, .value = {0, 2500 * 6.0}};
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(load);
  Solid solid(scene);
  run(solid, 1);
  return std::abs(solid.states()[0].displacement[0] - 1);  // a = 6 t: x = t^3
}

TEST(Solid, IntegratorsShowTheirOrder) {
  for (const auto& [integrator, order] :
       {std::pair{scene::Integrator::shi, 1.0}, std::pair{scene::Integrator::trapezoidal, 2.0},
        std::pair{scene::Integrator::generalized_alpha, 2.0}}) {
    const double slope = std::log2(error_of(integrator, 0.02) / error_of(integrator, 0.01));
    EXPECT_NEAR(slope, order, 0.1);
  }
}

/// The lower crack of the reconstruction under water `head_m` above its mouth.
scene::Scene lower_crack() {
  auto scene = empty_scene();
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 30;
  add(scene, {{-15, -8}, {35, -8}, {35, -4}, {15.5, -4}, {15.5, 0}, {-15, 0}}, true);
  add(scene, {{0, 0}, {15.5, 0}, {0, 3.5}}, true);
  add(scene, {{0, 3.5}, {15.5, 0}, {4, 22}, {0, 22}});
  return scene;
}

std::vector<Panel> water_on_face(double head_m) {
  return {{.block = 2,
           .edge = 3,
           .s_from = 1 - head_m / 18.5,
           .s_to = 1,
           .pressure_from_pa = 0,
           .pressure_to_pa = 9810 * head_m}};
}

TEST(Solid, FirstAccelerationHalfAMetreAboveTheFailureLevelAgreesWithTheFormula) {
  const auto scene = lower_crack();
  Solid solid(scene);
  const auto water = water_on_face(17.550);  // the paper's 17.05 m and half a metre
  solid.settle(water);
  // The release gives back the elastic shear that held joints had carried: measured after that, over 0.3 s.
  const auto speed = [&] { return solid.states()[2].velocity.head<2>().norm(); };
  run(solid, 0.2, water);
  const double before = speed();
  run(solid, 0.3, water);
  const double acceleration = (speed() - before) / 0.3;
  EXPECT_NEAR(acceleration / 0.19206, 1, 0.01);
}

TEST(Solid, SlidingStartsAtTheSameHeadWhateverThePenalty) {
  for (const double penalty : {5e6, 1e9, 1e12}) {
    auto scene = lower_crack();
    scene.contact.initial_penalty_n_per_m2 = penalty;
    for (const auto& [head, slides] : {std::pair{17.06, false}, std::pair{17.08, true}}) {
      Solid solid(scene);
      solid.settle(water_on_face(16));
      for (int n = 0; n < 50; ++n) {  // 1 m of water in half a second, then held
        solid.advance(n * 0.01, (n + 1) * 0.01, water_on_face(16 + (head - 16) * (n + 1) / 50));
      }
      for (int n = 50; n < 150; ++n) solid.advance(n * 0.01, (n + 1) * 0.01, water_on_face(head));
      EXPECT_EQ(solid.states()[2].velocity.head<2>().norm() > 1e-3, slides)
          << "penalty " << penalty << ", head " << head;
    }
  }
}

TEST(Solid, APenaltyThatStartsLowRisesUntilItCostsNoMoreSolutions) {
  const auto solutions = [](std::optional<double> penalty) {
    auto scene = lower_crack();
    scene.contact.initial_penalty_n_per_m2 = penalty;
    Solid solid(scene);
    solid.settle(water_on_face(16));
    for (int n = 0; n < 100; ++n) solid.advance(n * 0.01, (n + 1) * 0.01, water_on_face(16 + n * 0.01));
    return static_cast<double>(solid.counts().iterations);
  };
  EXPECT_LE(solutions(5e6), 1.2 * solutions({}));
}

/// The difference of two times is round-off; matrices, and with them their factors, stand from step to step.
TEST(Solid, StepsAreTheSameToTheLastDigitWhateverTheClockSays) {
  const auto moved_from = [](double from_s) {
    auto scene = lower_crack();
    Solid solid(scene);
    solid.settle(water_on_face(18));
    for (int n = 0; n < 50; ++n) solid.advance(from_s + n * 0.01, from_s + (n + 1) * 0.01, water_on_face(18));
    return solid.states()[2].displacement;
  };
  EXPECT_GT(moved_from(0).norm(), 0.01);
  EXPECT_EQ(moved_from(0), moved_from(1000));
}

TEST(Solid, AStepThatGoesTooFarIsCutAndNotTriedInOtherWays) {
  auto scene = empty_scene();
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 30;
  add(scene, {{-1, -1}, {9, -1}, {9, 0}, {-1, 0}}, true);
  add(scene, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  scene.blocks[1].initial_velocity_m_per_s = {6, 0};
  Solid solid(scene);
  run(solid, 0.5);
  EXPECT_GT(solid.counts().undone_steps, 0);
  EXPECT_EQ(solid.counts().substituted_steps, 0);
  // Nothing has moved since the contacts of a step that is undone were found.
  EXPECT_LE(solid.counts().searches, solid.counts().steps);
  const double braked = 9.81 * std::tan(std::numbers::pi / 6);
  EXPECT_NEAR(solid.states()[1].velocity.x(), 6 - 0.5 * braked, 1e-3);
}

TEST(Solid, KeptCohesionAddsItsForceToFriction) {
  auto scene = lower_crack();
  scene.default_joint.cohesion_pa = 20e3;
  scene.default_joint.keeps_cohesion = true;
  // T - N tan(phi) = c L fixes the head: W = 4595.4 kN, dip 12.724 deg, L = 15.890 m.
  const double a = std::atan(3.5 / 15.5);
  const double weight = 187.375 * 2500 * 9.81;
  const double mu = std::tan(std::numbers::pi / 6);
  const double push =
      (weight * (std::cos(a) * mu - std::sin(a)) + 20e3 * std::hypot(15.5, 3.5)) / (std::cos(a) + std::sin(a) * mu);
  const double head = std::sqrt(2 * push / 9810);
  for (const auto& [z, slides] : {std::pair{head * 0.999, false}, std::pair{head * 1.001, true}}) {
    Solid solid(scene);
    solid.settle(water_on_face(z));
    run(solid, 1, water_on_face(z));
    EXPECT_EQ(solid.states()[2].velocity.head<2>().norm() > 1e-3, slides) << z;
  }
}

TEST(Solid, ABrittleBondBreaksInShearOnceAllOfItsJointSlips) {
  // Uneven normal forces let one end of the joint slip at about 0.94 of the push that the joint can bear.
  const double weight = 4 * 2500 * 9.81;
  const double strength = weight * std::tan(std::numbers::pi / 6) + 20e3 * 4;
  for (const auto& [share, slides] : {std::pair{0.99, false}, std::pair{1.01, true}}) {
    auto scene = empty_scene();
    scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 30;
    scene.default_joint.cohesion_pa = 20e3;
    add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
    add(scene, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    scene::PointLoad load{.block = 1, .point_m = Point(0, 0.2)};
    load.force_x_n_per_m = {.time_s = {0, 0.5}, .value = {0, share * strength}};
    load.force_y_n_per_m = scene::TimeTable::constant(0);
    scene.point_loads.push_back(load);
    Solid solid(scene);
    solid.settle({});
    run(solid, 1);
    bool bonded = false;
    for (const ContactPoint& c : solid.contacts()) bonded = bonded || c.bonded();
    EXPECT_EQ(bonded, !slides) << share;
    EXPECT_EQ(solid.states()[1].velocity[0] > 1e-3, slides) << share;
  }
}

/// Blocks with one strain stick until next to all joints slip at both ends: 50 cubes were left ringing.
TEST(Solid, AColumnThatWidensStartsInEquilibrium) {
  auto scene = empty_scene();
  scene.default_joint.friction_angle_deg = 45;
  add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
  for (int i = 0; i < 50; ++i) add(scene, {{0, i + 0.0}, {1, i + 0.0}, {1, i + 1.0}, {0, i + 1.0}});
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.02);
  double normal = 0;
  for (const ContactPoint& c : solid.contacts()) {
    if (std::min(c.vertex_block, c.edge_block) == 0) normal += c.force.x();
  }
  EXPECT_NEAR(normal / (50 * 2500 * 9.81), 1, 1e-5);  // held: 1e-2
}

/// The two ends of its base pull against each other a thousand times as stiffly as the pillar gives way upwards.
TEST(Solid, APillarOfOneToAThousandStartsInEquilibrium) {
  auto scene = empty_scene();
  scene.analysis.gravity_tilt_deg = 0.01;
  add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
  add(scene, {{0, 0}, {0.001, 0}, {0.001, 1}, {0, 1}});
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.1);
  EXPECT_LT(solid.largest_displacement_m(), 1e-5);
}

/// Both ends of its base stick at slips that differ by the round-off of the plane's coordinates.
TEST(Solid, ARigidBlockOnASlopeStartsInEquilibrium) {
  auto scene = empty_scene();
  scene.analysis.rigid = scene::Rigid::all;
  scene.default_joint.friction_angle_deg = 40;
  const Point along(std::cos(std::numbers::pi / 6), -0.5);
  const Point up(0.5, std::cos(std::numbers::pi / 6));
  const auto at = [&](double x, double y) { return Point(7 * along + x * along + y * up); };
  add(scene, {at(-9, -1), at(9, -1), at(9, 0), at(-9, 0)}, true);
  add(scene, {at(0, 0), at(0.5, 0), at(0.5, 0.2), at(0, 0.2)});
  Solid solid(scene);
  solid.settle({});
  run(solid, 0.1);
  EXPECT_LT(solid.largest_displacement_m(), 1e-9);
}

TEST(Solid, ALedPointGoesWhereItsTableSays) {
  auto scene = empty_scene();
  scene.analysis.gravity_m_per_s2 = 0;
  add(scene, {{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  for (const double y : {0.0, 1.0}) {
    scene::Support support;
    support.point_m = Point(0, y);
    support.displacement_x_m = scene::TimeTable{.time_s = {0, 1}, .value = {0, 0.1}};
    support.displacement_y_m = scene::TimeTable::constant(0);
    scene.supports.push_back(support);
  }
  Solid solid(scene);
  run(solid, 1);
  EXPECT_NEAR(solid.placements()[0].position(solid.blocks()[0].vertices[0]).x(), 0.1, 1e-9);
  EXPECT_NEAR(solid.placements()[0].position(solid.blocks()[0].vertices[0]).y(), 0, 1e-9);
}

TEST(Solid, SparseAndDenseSolversGiveTheSameCorrection) {
  const std::vector<std::pair<int, int>> couples = {{0, 1}, {1, 2}};
  const Unknowns unknowns({6, 3, 6});
  auto dense = make_dense_system(unknowns);
  auto sparse = sparse_solvers().make_sparse_system(unknowns, couples);
  for (const auto& system : {dense.get(), sparse.get()}) {
    system->set_zero();
    for (int b = 0; b < 3; ++b) system->add(b, b, 10 * Matrix6::Identity() + Matrix6::Ones());
    for (const auto& [i, j] : couples) {
      system->add(i, j, 0.5 * Matrix6::Ones());
      system->add(j, i, 0.5 * Matrix6::Ones());
    }
  }
  const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(15, 1, 15);
  Eigen::VectorXd d0(15);
  for (const bool symmetric : {true, false}) {
    Eigen::VectorXd d1(15);
    ASSERT_TRUE(dense->solve(symmetric, f, d0));
    ASSERT_TRUE(sparse->solve(symmetric, f, d1));
    EXPECT_LT((d0 - d1).norm(), 1e-12 * d0.norm());
  }
}

}  // namespace
}  // namespace blockweir::solid::solid_test
