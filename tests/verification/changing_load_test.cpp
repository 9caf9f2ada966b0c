// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Many bricks under a load that rises: each step finds its states in few solutions, and its forces carry the load.
#include <gtest/gtest.h>

#include <cmath>

#include "solid/step/solid.hpp"
#include "tests/large_scenes.hpp"

namespace blockweir::solid::changing_load_test {
namespace {

/// Solutions a step of a dam whose water rises.
double solutions_a_step(int bricks, scene::Rigid rigid) {
  constexpr int steps = 40;
  auto scene = brick_dam(bricks);
  scene.analysis.rigid = rigid;
  scene.analysis.sleep = false;
  const double dt = scene.analysis.step_s;
  Solid solid(scene);
  solid.settle({});
  const long settled = solid.counts().iterations;
  for (int n = 0; n < steps; ++n) solid.advance(n * dt, (n + 1) * dt, {});

  double weight = 0;
  for (const Block& block : solid.blocks()) weight += block.fixed ? 0 : block.mass_per_m() * 9.81;
  double base_shear = 0;
  double base_reaction = 0;
  for (const ContactPoint& c : solid.contacts()) {
    if (c.edge_block != 0 || c.state == ContactState::open) continue;
    base_reaction += c.force.x();
    base_shear += c.force.y();
  }
  const double rows = std::round(std::sqrt(bricks));
  const double depth = rows / 2 + 4 * steps * dt;
  EXPECT_NEAR(base_reaction / weight, 1, 1e-6) << bricks;
  EXPECT_NEAR(std::abs(base_shear) / (9810 * depth * depth / 2), 1, 0.01) << bricks;
  return static_cast<double>(solid.counts().iterations - settled) / steps;
}

/// Where all states were judged anew after each sweep, and gaps of a round-off chased, it took 8.9 and 48.9.
TEST(ChangingLoad, TakesFewSolutionsAStep) {
  EXPECT_LT(solutions_a_step(300, scene::Rigid::all), 8.5);
  EXPECT_LT(solutions_a_step(100, scene::Rigid::none), 25);
}

}  // namespace
}  // namespace blockweir::solid::changing_load_test
