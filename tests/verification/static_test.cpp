// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Static analysis against formulas, limits and the end of a damped motion; what is not a number ends a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "solid/step/solid.hpp"

namespace blockweir::solid::static_test {
namespace {

scene::Scene empty_scene() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "ground", .vertices = {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, .fixed = true});
  return scene;
}

/// Ten blocks of 1 m on each other, pushed aside at the top.
scene::Scene column(double push, scene::AnalysisKind kind) {
  auto scene = empty_scene();
  scene.materials[0].poissons_ratio = 0;  // no shear between blocks but the load's: what slips depends on the path
  scene.analysis.kind = kind;
  for (int i = 0; i < 10; ++i) {
    scene.blocks.push_back(
        {.name = "b" + std::to_string(i), .vertices = {{0, i + 0.0}, {2, i + 0.0}, {2, i + 1.0}, {0, i + 1.0}}});
  }
  scene::PointLoad load{.block = 10, .point_m = Point(0, 9.5)};
  load.force_x_n_per_m = {.time_s = {0, 1}, .value = {0, push}};
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(load);
  return scene;
}

TEST(Static, AColumnComesToRestUnderTheLoadOfItsEnd) {
  const auto scene = column(5e3, scene::AnalysisKind::at_rest);
  Solid solid(scene);
  solid.settle({});
  solid.advance(1, 1, {});
  EXPECT_TRUE(solid.state().rest.found);
  EXPECT_LE(solid.state().rest.unbalanced, 1e-8);
  double normal = 0;
  double shear = 0;
  for (const ContactPoint& c : solid.contacts()) {
    if (std::min(c.vertex_block, c.edge_block) != 0) continue;
    normal += c.force.x();
    shear += c.force.y();
  }
  EXPECT_NEAR(normal / (20 * 2500 * 9.81), 1, 1e-7);
  EXPECT_NEAR(std::abs(shear) / 5e3, 1, 1e-4);
}

TEST(Static, AgreesWithTheEndOfALongDampedMotion) {
  const auto at_rest = column(5e3, scene::AnalysisKind::at_rest);
  Solid found(at_rest);
  found.settle({});
  found.advance(1, 1, {});
  auto moving = column(5e3, scene::AnalysisKind::dynamic);
  moving.materials[0].damping_ratio = 0.5;
  moving.analysis.mass_damping_per_s = 20;
  Solid ended(moving);
  ended.settle({});
  for (int n = 0; n < 300; ++n) ended.advance(n * 0.01, (n + 1) * 0.01, {});
  const double top = found.states()[10].displacement[0];
  EXPECT_GT(top, 1e-7);
  EXPECT_NEAR(ended.states()[10].displacement[0] / top, 1, 1e-3);
}

TEST(Static, ABlockThatNothingHoldsFindsNoRest) {
  for (const auto& [share, holds] : {std::pair{0.99, true}, std::pair{1.01, false}}) {
    auto scene = empty_scene();
    scene.analysis.kind = scene::AnalysisKind::at_rest;
    scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 30;
    scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {4, 0}, {4, 1}, {0, 1}}});
    scene::PointLoad load{.block = 1, .point_m = Point(0, 0)};
    load.force_x_n_per_m = scene::TimeTable::constant(share * 4 * 2500 * 9.81 / std::sqrt(3.0));
    load.force_y_n_per_m = scene::TimeTable::constant(0);
    scene.point_loads.push_back(load);
    Solid solid(scene);
    solid.settle({});
    solid.advance(1, 1, {});
    EXPECT_EQ(solid.state().rest.found, holds) << share;
    if (!holds) {
      EXPECT_NEAR(solid.state().rest.unbalanced, 0.01 / std::sqrt(3.0), 1e-3);
    }
  }
}

/// In the form "support", too: statics has no time to move the ground in.
TEST(Static, ASeismicCoefficientIsABaseAcceleration) {
  for (const auto& [share, holds, form] :
       {std::tuple{0.99, true, scene::BaseForm::inertia}, std::tuple{1.01, false, scene::BaseForm::inertia},
        std::tuple{0.99, true, scene::BaseForm::support}, std::tuple{1.01, false, scene::BaseForm::support}}) {
    auto scene = empty_scene();
    scene.analysis.kind = scene::AnalysisKind::at_rest;
    scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 20;
    scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {4, 0}, {4, 1}, {0, 1}}});
    scene.base_motion.emplace();
    scene.base_motion->form = form;
    scene.base_motion->acceleration_x_m_per_s2 = {.time_s = {0, 1},
                                                  .value = {0, share * 9.81 * std::tan(std::acos(-1.0) / 9)}};
    Solid solid(scene);
    solid.settle({});
    solid.advance(1, 1, {});
    EXPECT_EQ(solid.state().rest.found, holds) << share;
  }
}

/// What a run says that meets a number beyond all bounds.
std::string complaint(const scene::Scene& scene) {
  try {
    Solid solid(scene);
    for (int n = 0; n < 5; ++n) solid.advance(n * 0.01, (n + 1) * 0.01, {});
  } catch (const NotFinite& error) {
    return error.what();
  }
  return "";
}

TEST(NotFinite, NamesTheBlockTheTimeAndTheStep) {
  auto scene = empty_scene();
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {4, 0}, {4, 1}, {0, 1}}});
  scene::PointLoad load{.block = 1, .point_m = Point(0, 1)};
  load.force_x_n_per_m = {.time_s = {0, 0.02, 0.0201}, .value = {0, 0, 1.7e308}};
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads = {load, load};
  EXPECT_THAT(complaint(scene),
              testing::HasSubstr("the load of block \"block\" is not a finite number at 0.03 s (step 3)"));
  scene.point_loads.clear();
  scene.blocks[1].initial_velocity_m_per_s = Point(1e308, 1e308);
  scene.blocks[1].initial_spin_deg_per_s = 1e308;
  EXPECT_THAT(complaint(scene), testing::HasSubstr("of block \"block\" is not a finite number at 1e-08 s (step 1)"));
}

}  // namespace
}  // namespace blockweir::solid::static_test
