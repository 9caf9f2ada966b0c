// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Tilted walls that their joints do not hold move off alike with any step, and columns as one body. By sweeps alone the
// first step throws them: a force goes on by one block in each.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "solid/step/solid.hpp"
#include "tests/collapse_scenes.hpp"

namespace blockweir::solid::onset_of_motion_test {
namespace {

double moved_m(const scene::Scene& scene) {
  Solid solid(scene);
  const double dt = scene.analysis.step_s;
  const long steps = std::lround(scene.analysis.duration_s / dt);
  for (long n = 0; n < steps; ++n) solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, {});
  return solid.largest_displacement_m();
}

void expect_alike(const std::string& blocks, double duration_s, double tilt_deg, double within) {
  scene::Scene scene = test::collapse(blocks, duration_s, tilt_deg, 30);
  const double moved = moved_m(scene);
  scene.analysis.step_s /= 4;
  EXPECT_GT(moved, 2e-3);
  EXPECT_NEAR(moved, moved_m(scene), within * moved) << "tilted by " << tilt_deg << " degrees";
}

TEST(OnsetOfMotion, IsAlikeWithAnyStep) {
  for (const double tilt_deg : {9.0, 10.0, 12.0}) expect_alike(test::wall(26, 2, 1), 0.3, tilt_deg, 0.02);
}

TEST(OnsetOfMotion, OfAThousandBricksIsAlikeWithAnyStep) {
  expect_alike(test::wall(50, 20, 1), 0.15, 24, 0.03);
}

/// Of blocks one on another, which turns over about its toe as one body: gravity is tilted by so much more than that
/// takes.
struct Column {
  int blocks;
  double height_m;
  double width_m;
  double excess;

  [[nodiscard]] double tilt() const { return std::atan(width_m / height_m * (1 + excess)); }

  [[nodiscard]] scene::Scene scene(double duration_s, bool rigid) const {
    std::string text = fmt::format(
        "[[block]]\nname = \"ground\"\nmaterial = \"stone\"\nfixed = true\n"
        "vertices_m = [[{0}, {0}], [{1}, {0}], [{1}, 0], [{0}, 0]]\n",
        -height_m, 3 * height_m);
    const double h = height_m / blocks;
    for (int b = 0; b < blocks; ++b) {
      text += fmt::format(
          "[[block]]\nname = \"b{0}\"\nmaterial = \"stone\"\nvertices_m = [[0, {1}], [{3}, {1}], [{3}, {2}], [0, "
          "{2}]]\n",
          b, b * h, (b + 1) * h, width_m);
    }
    scene::Scene all = test::collapse(text, duration_s, tilt() * 180 / std::numbers::pi, 45);
    all.analysis.start = scene::Start::equilibrium;
    all.analysis.rigid = rigid ? scene::Rigid::all : scene::Rigid::none;
    return all;
  }
  /// Theta'' = g r / k^2 sin(theta - theta_0) about the toe, with a midpoint rule [rad].
  [[nodiscard]] double turn(double after_s) const {
    const double lean = std::atan2(width_m, height_m) - tilt();
    const double rate = 9.81 * std::hypot(width_m, height_m) / 2 * 3 / (width_m * width_m + height_m * height_m);
    constexpr int steps = 20'000;
    const double dt = after_s / steps;
    double angle = 0;
    double speed = 0;
    for (int n = 0; n < steps; ++n) {
      speed += dt / 2 * rate * std::sin(angle - lean);
      angle += dt * speed;
      speed += dt / 2 * rate * std::sin(angle - lean);
    }
    return angle;
  }
};

double turned(const scene::Scene& scene) {
  Solid solid(scene);
  const double dt = scene.analysis.step_s;
  const long steps = std::lround(scene.analysis.duration_s / dt);
  solid.settle({});
  for (long n = 0; n < steps; ++n) solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, {});
  return -solid.states().back().displacement[2];
}

TEST(OnsetOfMotion, OfAColumnIsThatOfOneBody) {
  const Column tall{60, 20, 1, 0.1};
  EXPECT_NEAR(turned(tall.scene(1.4, true)), tall.turn(1.4), 0.01 * tall.turn(1.4));
  const Column straining{40, 8.6, 0.215, 0.01};
  EXPECT_NEAR(turned(straining.scene(1.8, false)), straining.turn(1.8), 0.02 * straining.turn(1.8));
}

/// Blocks that strain sway a little before they turn: by half at least of what one body does.
TEST(OnsetOfMotion, NoColumnStandsBeyondItsLimit) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    const auto any = [&](double from, double to) { return from + (to - from) * share(random); };
    const double height_m = std::exp(any(0, 3));
    const Column column{static_cast<int>(any(40, 90)), height_m, height_m / any(10, 40), any(0.01, 0.05)};
    const double after_s = 3 * std::sqrt(height_m / 9.81);
    for (const bool rigid : {true, false}) {
      EXPECT_GT(turned(column.scene(after_s, rigid)), 0.5 * column.turn(after_s))
          << "seed " << seed << ": " << column.blocks << (rigid ? " rigid" : "") << " blocks";
    }
  }
}

}  // namespace
}  // namespace blockweir::solid::onset_of_motion_test
