// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Walls of bricks some of which strain and some of which do not.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid::rigid_among_straining_test {
namespace {

/// In running bond, of any size and stiffness, upright or tilted by up to 10 degrees.
scene::Scene random_wall(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto any = [&](double from, double to) { return from + (to - from) * share(random); };
  const double height = std::pow(10.0, any(-1.3, 1.3));
  const double length = any(1, 3) * height;
  const double rigid = share(random);
  const int rows = static_cast<int>(any(1, 8));
  const int columns = static_cast<int>(any(1, 6));
  auto scene = empty_scene();
  scene.materials[0].youngs_modulus_pa = std::pow(10.0, any(8, 11));
  scene.analysis.gravity_tilt_deg = any(-10, 10);
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 35;
  add(scene, {{-20 * height, -height}, {60 * height, -height}, {60 * height, 0}, {-20 * height, 0}}, true);
  for (int row = 0; row < rows; ++row) {
    for (double from = row % 2 == 0 ? 0 : -length / 2; from < columns * length; from += length) {
      const double a = std::max(0.0, from);
      const double b = std::min(columns * length, from + length);
      if (b - a < length / 4) continue;
      add(scene, {{a, row * height}, {b, row * height}, {b, (row + 1) * height}, {a, (row + 1) * height}});
      scene.blocks.back().rigid = share(random) < rigid;
    }
  }
  return scene;
}

TEST(RigidAmongStraining, WallsFindTheirFirstEquilibrium) {
  int resting = 0;
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const scene::Scene scene = random_wall(seed);
    Solid solid(scene);
    ASSERT_NO_THROW(solid.settle({})) << "seed " << seed;
    if (!solid.starts_at_rest()) continue;  // slower than 1e-4 g
    ++resting;
    double weight_n = 0;
    for (const Block& block : solid.blocks()) weight_n += block.fixed ? 0 : block.mass_per_m() * 9.81;
    double bears_n = 0;
    for (const ContactPoint& c : solid.contacts()) bears_n += c.vertex_block * c.edge_block == 0 ? c.force.x() : 0;
    const double upright = std::cos(scene.analysis.gravity_tilt_deg * std::numbers::pi / 180);
    EXPECT_NEAR(bears_n / weight_n, upright, 1e-4) << "seed " << seed;
  }
  EXPECT_GE(resting, 16);
}

}  // namespace
}  // namespace blockweir::solid::rigid_among_straining_test
