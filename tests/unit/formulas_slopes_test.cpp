// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_expect bridge_scene_read
// Limit equilibrium of toppling columns against the published example and against a single block.
#include <gtest/gtest.h>

#include <cmath>

#include "bridge/scene/read/read.hpp"
#include "solid/expect/formulas.hpp"

namespace blockweir::solid::expect::formulas_slopes_test {
namespace {

TEST(TopplingSlope, OfGoodmanAndBrayNeedsThePublishedFriction) {
  const auto scene = scene::read(BLOCKWEIR_SOURCE "/cases/toppling-slope").scene;
  EXPECT_NEAR(formula(scene, {.formula = "toppling-slope-friction"}), 38.15, 5e-3);
}

TEST(TopplingSlope, OfOneBroadBlockSlidesAtItsDip) {
  scene::Scene scene;
  scene.materials.push_back({"rock", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {4, 0}, {4, 1}, {0, 1}}});
  for (const double dip : {10.0, 25.0, 40.0}) {
    scene.analysis.gravity_tilt_deg = dip;
    EXPECT_NEAR(formula(scene, {.formula = "toppling-slope-friction"}), dip, 1e-6);
  }
}

TEST(TopplingSlope, OfOneSlenderBlockIsAnError) {
  scene::Scene scene;
  scene.materials.push_back({"rock", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {1, 0}, {1, 4}, {0, 4}}});
  scene.analysis.gravity_tilt_deg = 20;
  EXPECT_THROW(formula(scene, {.formula = "toppling-slope-friction"}), std::runtime_error);
}

TEST(TopplingSlope, OfAnythingButRectanglesIsAnError) {
  scene::Scene scene;
  scene.materials.push_back({"rock", 50e9, 0.2, 2500});
  scene.blocks.push_back({.name = "block", .vertices = {{0, 0}, {4, 0}, {4, 2}, {0, 1}}});
  EXPECT_THROW(formula(scene, {.formula = "toppling-slope-friction"}), std::runtime_error);
}

TEST(TopplingSlope, ChangesNothingWithTheUnitOfLength) {
  auto scene = scene::read(BLOCKWEIR_SOURCE "/cases/toppling-slope").scene;
  const double friction = formula(scene, {.formula = "toppling-slope-friction"});
  for (auto& block : scene.blocks) {
    for (auto& vertex : block.vertices) vertex *= 0.01;
  }
  EXPECT_NEAR(formula(scene, {.formula = "toppling-slope-friction"}), friction, 1e-9);
}

}  // namespace
}  // namespace blockweir::solid::expect::formulas_slopes_test
