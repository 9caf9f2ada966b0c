// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// Blocks with a mesh against closed answers: rigid motion, uniform strain, contact through the mesh, spinning.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solid/block/corners.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/make_frame.hpp"
#include "solid/watch/stress_field.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::mesh_test {
namespace {

scene::Scene empty_scene() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  return scene;
}

void add(scene::Scene& scene, std::vector<Point> vertices, double mesh_size_m = 0) {
  scene::Block block;
  block.name = "b" + std::to_string(scene.blocks.size());
  block.vertices = std::move(vertices);
  block.mesh_size_m = mesh_size_m;
  scene.blocks.push_back(block);
}

void add_ground(scene::Scene& scene) {
  add(scene, {{-20, -2}, {20, -2}, {20, 0}, {-20, 0}});
  scene.blocks.back().fixed = true;
}

TEST(Mesh, AnIncrementFollowsFromItsCorners) {
  const scene::Block described{.name = "t", .vertices = {{0, 0}, {3, 1}, {1, 2}}};
  const Block triangle = make_block(described, {"m", 1e9, 0.2, 2500}, scene::Plane::strain);
  Vector6 start;
  start << 1, -2, 0.7, 1e-3, -2e-3, 3e-3;
  Vector6 increment;
  increment << 0.2, 0.1, -0.4, 2e-3, 1e-3, -4e-3;
  const Placement from(triangle.centroid, start);
  Vector6 moved;
  for (int i = 0; i < 3; ++i) {
    moved.segment<2>(2 * i) = from.increment(increment, triangle.vertices[static_cast<std::size_t>(i)]);
  }
  EXPECT_LT((increment_of(triangle, from, moved) - increment).norm(), 1e-15);
}

TEST(Mesh, CornersFollowFromSixUnknownsAndTheOtherWayRound) {
  const scene::Block described{.name = "t", .vertices = {{0, 0}, {3, 1}, {1, 2}}};
  const Block triangle = make_block(described, {"m", 1e9, 0.2, 2500}, scene::Plane::strain);
  Vector6 strained;
  strained << 1, -2, 0.7, 0.1, -0.2, 0.3;
  const Placement at(triangle.centroid, strained);
  EXPECT_LT((corner_map(triangle, at) * corner_shape(triangle, at) - Matrix6::Identity()).norm(), 1e-14);
}

/// Contacts of a mesh meet the stiffness of a node, not that of a small triangle's mean motion: with penalties to
/// match, multipliers settle in a sweep or two a step, which costs little beside springs that need none.
TEST(Mesh, MultipliersOfABondedBeamCostLittleBesideSprings) {
  const auto solutions = [](scene::ContactFormulation formulation) {
    auto scene = empty_scene();
    scene.analysis.kind = scene::AnalysisKind::quasi_static;
    scene.contact.formulation = formulation;
    scene.default_joint.cohesion_pa = scene.default_joint.tension_strength_pa = 1e9;
    add(scene, {{-1, -1}, {0, -1}, {0, 1}, {-1, 1}});
    scene.blocks.back().fixed = true;
    add(scene, {{0, -0.5}, {5, -0.5}, {5, 0.5}, {0, 0.5}}, 0.25);
    Solid solid(scene);
    solid.settle({});
    return solid.counts().iterations;
  };
  EXPECT_LE(solutions(scene::ContactFormulation::augmented_lagrangian),
            2 * solutions(scene::ContactFormulation::penalty));
}

TEST(Mesh, AFallingBlockStaysWhole) {
  auto scene = empty_scene();
  scene.analysis.max_displacement_ratio = 10;
  add(scene, {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 1);
  scene.blocks[0].initial_velocity_m_per_s = Point(2, 5);
  Solid solid(scene);
  run(solid, 1);
  EXPECT_NEAR(solid.states()[0].displacement[0], 2, 1e-10);
  EXPECT_NEAR(solid.states()[0].displacement[1], 5 - 9.81 / 2, 1e-9);
  EXPECT_NEAR(solid.states()[0].velocity[1], 5 - 9.81, 1e-9);
  for (std::size_t t = 1; t < solid.blocks().size(); ++t) {
    EXPECT_LT(solid.states()[t].displacement.tail<4>().norm(), 1e-10);
  }
}

TEST(Mesh, ASpinningBlockTurnsAsOneWithoutAMesh) {
  for (const auto integrator : {scene::Integrator::trapezoidal, scene::Integrator::generalized_alpha}) {
    auto scene = empty_scene();
    scene.analysis.gravity_m_per_s2 = 0;
    scene.analysis.integrator = integrator;
    scene.analysis.step_s = 2e-3;
    scene.analysis.max_displacement_ratio = 1;
    add(scene, {{0, 0}, {3, 0}, {2, 1}, {0, 1.5}}, 0.7);
    scene.blocks[0].initial_spin_deg_per_s = 360;
    Solid solid(scene);
    run(solid, 2);
    EXPECT_NEAR(solid.states()[0].displacement[2] / (2 * std::numbers::pi), 2, 1e-3);
    EXPECT_NEAR(solid.states()[0].velocity[2] / (2 * std::numbers::pi), 1, 1e-3);
    // Corners that triangles share stay together.
    std::vector<std::pair<bool, Point>> node(static_cast<std::size_t>(solid.parts().nodes));
    for (std::size_t t = 1; t < solid.blocks().size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Point p = solid.placements()[t].position(solid.blocks()[t].vertices[i]);
        auto& [known, place] = node[static_cast<std::size_t>(solid.blocks()[t].nodes[i])];
        if (known) EXPECT_LT((place - p).norm(), 1e-11);
        known = true;
        place = p;
      }
    }
  }
}

/// Plane stress without lateral strain: mean stress -rho g h/2, and at each height -rho g (h - y).
TEST(Mesh, OwnWeightGivesAStressThatGrowsWithDepth) {
  auto scene = empty_scene();
  scene.materials[0].poissons_ratio = 0;
  scene.analysis.plane = scene::Plane::stress;
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 0;
  add_ground(scene);
  add(scene, {{0, 0}, {2, 0}, {2, 6}, {0, 6}}, 0.5);
  Solid solid(scene);
  solid.settle({});
  const double unit_weight = 2500 * 9.81;
  EXPECT_NEAR(stress_in_block(solid.blocks()[1], solid.states()[1].displacement)[1] / (-unit_weight * 3), 1, 1e-6);
  const StressField field(solid, 1);
  for (const Point& p : {Point(1, 0.1), Point(0.3, 2), Point(1.7, 4), Point(1, 5.9)}) {
    EXPECT_NEAR(field.stress_at(p)[1], -unit_weight * (6 - p.y()), 0.01 * unit_weight * 6) << p.transpose();
  }
}

/// The solid counts triangles as blocks, too; what a fluid may press on are the scene's.
TEST(Mesh, AFluidPressesOnTheScenesBlocksAndNotOnTriangles) {
  auto scene = empty_scene();
  add_ground(scene);
  add(scene, {{0, 0}, {2, 0}, {2, 6}, {0, 6}}, 2);
  const Solid solid(scene);
  wire::Load load;
  for (auto* list : {&load.s_from, &load.pressure_from_pa, &load.pressure_to_pa}) list->own() = {0};
  load.s_to.own() = {1};
  load.edge.own() = {1};
  load.block.own() = {1};
  EXPECT_EQ(panels_of(load, solid).size(), 1U);
  ASSERT_GT(solid.blocks().size(), 2U);
  load.block.own() = {2};
  try {
    panels_of(load, solid);
    FAIL() << "a triangle was pressed on";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "loads block 2, edge 1, which the scene does not have; give both sides one scene");
  }
}

/// Contact forces of a block on the ground carry its weight, whatever its mesh.
TEST(Mesh, ContactsCarryTheWeightAndShareTheJoint) {
  for (const double size : {0.0, 2.0, 0.5}) {
    auto scene = empty_scene();
    add_ground(scene);
    add(scene, {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, size);
    add(scene, {{0, 3}, {4, 3}, {4, 5}, {0, 5}}, size);
    Solid solid(scene);
    solid.settle({});
    for (const int upper : {1, 2}) {
      double normal = 0;
      double length = 0;
      for (const ContactPoint& c : solid.contacts()) {
        if (std::max(c.vertex_block, c.edge_block) != upper) continue;
        normal += c.force.x();
        length += c.length;
      }
      EXPECT_NEAR(normal / ((upper == 1 ? 20 : 8) * 2500 * 9.81), 1, 1e-8) << size;
      EXPECT_NEAR(length, 4, 1e-6) << size;
    }
  }
}

}  // namespace
}  // namespace blockweir::solid::mesh_test
