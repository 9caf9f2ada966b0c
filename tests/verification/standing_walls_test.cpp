// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step solid_limit bridge_scene_read
// Walls of bricks near the slope at which they fail: those that limit analysis lets stand do not move at all, however
// many of their contacts are at their limits; the others fall.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "bridge/statics/loads.hpp"
#include "solid/limit/limit_analysis.hpp"
#include "solid/step/solid.hpp"
#include "tests/collapse_scenes.hpp"

namespace blockweir::solid::standing_walls_test {
namespace {

struct Wall {
  int rows;
  int columns;
  double brick_length_m;
  double tilt_deg;
  double friction_deg;

  [[nodiscard]] scene::Scene scene(double more_friction = 1) const {
    return test::collapse(test::wall(rows, columns, brick_length_m), 0.5, tilt_deg, more_friction * friction_deg);
  }
  [[nodiscard]] bool bears(double more_friction) const {
    const scene::Scene read = scene(more_friction);
    return limit::LimitAnalysis(read).bears(statics::weights_of(read));
  }
};

Wall random_wall(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto any = [&](double from, double to) { return from + (to - from) * share(random); };
  return {static_cast<int>(any(6, 20)), static_cast<int>(any(3, 7)), any(0.6, 1.6), any(8, 30), any(20, 45)};
}

double moved_m(const scene::Scene& scene) {
  Solid solid(scene);
  const double dt = scene.analysis.step_s;
  for (long n = 0; static_cast<double>(n) * dt < scene.analysis.duration_s; ++n) {
    solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, {});
  }
  return solid.largest_displacement_m();
}

/// BLOCKWEIR_CAMPAIGN=N: so many in place of a few.
TEST(StandingWalls, DoNotMoveWhereLimitAnalysisLetsThemStand) {
  constexpr double close = 0.01;  // of the friction angle
  const char* asked = std::getenv("BLOCKWEIR_CAMPAIGN");
  const unsigned seeds = asked != nullptr ? static_cast<unsigned>(std::stoul(asked)) : 24;
  int standing = 0;
  int falling = 0;
  double most_m = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Wall wall = random_wall(seed);
    const bool stands = wall.bears(1 - close);
    if (stands != wall.bears(1 + close)) continue;
    const double moved = moved_m(wall.scene());
    if (stands) {
      EXPECT_LE(moved, 1e-7) << "seed " << seed;
      most_m = std::max(most_m, moved);
    } else {
      EXPECT_GE(moved, 1e-3) << "seed " << seed;
    }
    ++(stands ? standing : falling);
  }
  EXPECT_GE(std::min(standing, falling), static_cast<int>(seeds / 10));
  fmt::print("{} walls stand and move by up to {:.1e} m, {} fall\n", standing, most_m, falling);
}

}  // namespace
}  // namespace blockweir::solid::standing_walls_test
