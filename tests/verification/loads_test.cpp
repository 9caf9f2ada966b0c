// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Loads against closed answers: lines, bodies, initial stress, a base that moves.
#include <gtest/gtest.h>

#include <cmath>

#include "solid/step/solid.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::loads_test {
namespace {

/// A free block of 2 m x 1 m without gravity.
scene::Scene free_block() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.max_displacement_ratio = 0.5;
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {2, 0}, {2, 1}, {0, 1}}});
  return scene;
}

scene::LineLoad uniform_line(const Point& from, const Point& to, const Point& force) {
  scene::LineLoad load{.block = 0, .from_m = from, .to_m = to};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    load.force_from_n_per_m2[axis] = load.force_to_n_per_m2[axis] =
        scene::TimeTable::constant(force[static_cast<Eigen::Index>(axis)]);
  }
  return load;
}

TEST(Loads, ATriangularLineLoadPushesAndTurns) {
  // 0 at (0, 0) to 6000 at (2, 0), upwards: 6000 N at x = 4/3, a third of a metre from the centroid.
  for (const bool reversed : {false, true}) {
    auto scene = free_block();
    scene::LineLoad load = uniform_line({0, 0}, {2, 0}, {0, 0});
    load.force_to_n_per_m2[1] = scene::TimeTable::constant(6000);
    if (reversed) std::swap(load.from_m, load.to_m), std::swap(load.force_from_n_per_m2, load.force_to_n_per_m2);
    scene.line_loads.push_back(load);
    Solid solid(scene);
    std::vector<Vector6> forces(1);
    Loads(scene, solid.parts()).evaluate(0, {}, solid.placements(), forces);
    EXPECT_NEAR(forces[0][0], 0, 1e-9);
    EXPECT_NEAR(forces[0][1], 6000, 1e-9);
    EXPECT_NEAR(forces[0][2], 2000, 1e-9);
  }
}

TEST(Loads, ALineLoadKeepsItsDirectionAndForceAsTheBlockTurns) {
  auto scene = free_block();
  scene.line_loads.push_back(uniform_line({2, 0}, {2, 1}, {500, -300}));
  const Solid solid(scene);
  Vector6 turned = Vector6::Zero();
  turned[2] = 1;
  turned[4] = 0.1;
  std::vector<Vector6> forces(1);
  Loads(scene, solid.parts()).evaluate(0, {}, {Placement(solid.blocks()[0].centroid, turned)}, forces);
  EXPECT_NEAR(forces[0][0], 500, 1e-9);
  EXPECT_NEAR(forces[0][1], -300, 1e-9);
}

TEST(Loads, BodyLoadsMoveBlocksAsTheirMassOrVolumeSays) {
  auto scene = free_block();
  scene.body_loads.push_back({.blocks = {0}, .value = {scene::TimeTable::constant(2), scene::TimeTable::constant(0)}});
  scene.body_loads.push_back({.blocks = {0},
                              .per_mass = false,
                              .value = {scene::TimeTable::constant(0), scene::TimeTable::constant(-2500 * 3)}});
  Solid solid(scene);
  run(solid, 1);
  EXPECT_NEAR(solid.states()[0].displacement[0], 1, 1e-9);
  EXPECT_NEAR(solid.states()[0].displacement[1], -1.5, 1e-9);
  EXPECT_NEAR(solid.states()[0].displacement.tail<4>().norm(), 0, 1e-15);
}

TEST(Loads, AnInitialStressIsInBalanceWithItsTractions) {
  // Tractions sigma n on all four faces.
  const Eigen::Vector3d s(-2e6, -5e6, 1.5e6);
  auto scene = free_block();
  scene.analysis.integrator = scene::Integrator::trapezoidal;
  scene.blocks[0].initial_stress_pa = s;
  scene.line_loads = {uniform_line({0, 0}, {2, 0}, {-s[2], -s[1]}), uniform_line({2, 0}, {2, 1}, {s[0], s[2]}),
                      uniform_line({2, 1}, {0, 1}, {s[2], s[1]}), uniform_line({0, 1}, {0, 0}, {-s[0], -s[2]})};
  Solid solid(scene);
  run(solid, 0.1);
  EXPECT_LT(solid.states()[0].displacement.norm(), 1e-15);
  EXPECT_TRUE(stress_in_block(solid.blocks()[0], solid.states()[0].displacement).isApprox(s, 1e-9));
}

TEST(Loads, AnInitialStressWithoutTractionsIsReleased) {
  auto scene = free_block();
  scene.materials[0].initial_stress_pa = {-2e6, -5e6, 1.5e6};
  scene.analysis.kind = scene::AnalysisKind::quasi_static;
  Solid solid(scene);
  run(solid, 0.1);
  EXPECT_LT(stress_in_block(solid.blocks()[0], solid.states()[0].displacement).norm(), 1);
  EXPECT_GT(solid.states()[0].displacement.tail<3>().norm(), 1e-5);
}

TEST(Loads, AMovingBaseCarriesHeldPointsAndFixedBlocks) {
  auto scene = free_block();
  scene.base_motion.emplace();
  scene.base_motion->form = scene::BaseForm::support;
  scene.base_motion->acceleration_x_m_per_s2 = {.time_s = {0, 1}, .value = {0, 6}};  // x = t^3
  scene.blocks.push_back({.name = "ground", .vertices = {{5, 0}, {6, 0}, {6, 1}, {5, 1}}, .fixed = true});
  for (const double y : {0.0, 1.0}) {
    scene.supports.push_back({.block = 0,
                              .point_m = Point(0, y),
                              .displacement_x_m = scene::TimeTable::constant(0),
                              .displacement_y_m = scene::TimeTable::constant(0)});
  }
  Solid solid(scene);
  run(solid, 1);
  EXPECT_NEAR(solid.placements()[0].position(solid.blocks()[0].vertices[0]).x(), 1, 1e-9);
  EXPECT_NEAR(solid.placements()[1].position(solid.blocks()[1].vertices[0]).x(), 6, 1e-12);
  EXPECT_NEAR(solid.states()[1].velocity[0], 3, 1e-12);
  EXPECT_LT(solid.largest_displacement_m(), 1e-3);
}

TEST(Loads, ADashpotFollowsAMovingBase) {
  // Both forms: the base rises with 1 m/s2, a contact of spring and dashpot bears m (g + 1).
  for (const auto form : {scene::BaseForm::inertia, scene::BaseForm::support}) {
    auto scene = free_block();
    scene.analysis.gravity_m_per_s2 = 9.81;
    scene.contact.formulation = scene::ContactFormulation::penalty;
    scene.contact.dashpot_ratio = 0.5;
    scene.base_motion.emplace();
    scene.base_motion->form = form;
    scene.base_motion->acceleration_y_m_per_s2 = scene::TimeTable::constant(1);
    scene.blocks.push_back({.name = "ground", .vertices = {{-1, -1}, {3, -1}, {3, 0}, {-1, 0}}, .fixed = true});
    Solid solid(scene);
    solid.settle({});
    run(solid, 0.5);
    double normal = 0;
    for (const ContactPoint& c : solid.contacts()) normal += c.force.x();
    EXPECT_NEAR(normal / (5000 * 10.81), 1, 1e-3);
    EXPECT_LT(solid.largest_displacement_m(), 1e-6);
  }
}

/// A force of 8 ms between the ends of two steps of 10 ms: the block has its impulse.
TEST(Loads, APulseShorterThanAStepIsNotMissed) {
  auto scene = free_block();
  scene::PointLoad load{.block = 0, .point_m = Point(1, 0.5)};
  load.force_x_n_per_m = {.time_s = {0, 0.501, 0.509}, .value = {0, 1e6, 0}, .stepwise = true};
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(load);
  Solid solid(scene);
  solid.settle({});
  run(solid, 1);
  EXPECT_NEAR(solid.states()[0].velocity[0], 1e6 * 0.008 / 5000, 1e-9);
}

/// Ground that shakes by rows of 5 ms in steps of 10 ms: a block on it is left behind by what it gains.
TEST(Loads, ARecordFinerThanTheStepIsNotSampled) {
  auto scene = free_block();
  scene.base_motion.emplace();
  auto& record = scene.base_motion->acceleration_x_m_per_s2;
  record = {};
  for (int row = 0; row <= 200; ++row) {
    record.time_s.push_back(0.005 * row);
    record.value.push_back(row % 2 == 0 ? 0 : 2);
  }
  Solid solid(scene);
  solid.settle({});
  run(solid, 1);
  EXPECT_NEAR(solid.states()[0].velocity[0], -1, 1e-9);
}

}  // namespace
}  // namespace blockweir::solid::loads_test
