// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step solid_watch bridge_scene_read
// Walls that fall and heaps make no energy, and no block is in another, by measures that are the test's own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "tests/collapse_scenes.hpp"
#include "tests/verification/watched_fall.hpp"

namespace blockweir::solid::collapse_test {
namespace {

using test::Fall;
using test::watched;

scene::Scene random_collapse(unsigned seed) {
  constexpr double duration_s = 2;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const double friction_deg = 15 + 30 * share(random);
  if (seed % 3 == 0) {
    return test::collapse(test::heap(10 + static_cast<int>(30 * share(random)), seed), duration_s, 0, friction_deg);
  }
  const int rows = 4 + static_cast<int>(10 * share(random));
  const int columns = 2 + static_cast<int>(3 * share(random));
  const double brick_length_m = 0.6 + share(random);
  return test::collapse(test::wall(rows, columns, brick_length_m), duration_s, 10 + 20 * share(random), friction_deg);
}

/// BLOCKWEIR_CAMPAIGN=N: so many in place of a few.
TEST(Collapse, OfRandomWallsAndHeapsMakesNoEnergyAndNoOverlap) {
  const char* asked = std::getenv("BLOCKWEIR_CAMPAIGN");
  const unsigned seeds = asked != nullptr ? static_cast<unsigned>(std::stoul(asked)) : 6;
  Fall worst;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Fall fall = watched(random_collapse(seed));
    EXPECT_LE(fall.made_over_dissipated, 1e-5) << "seed " << seed;
    EXPECT_LE(fall.overlap_m, 1e-6) << "seed " << seed;
    worst.made_over_dissipated = std::max(worst.made_over_dissipated, fall.made_over_dissipated);
    worst.overlap_m = std::max(worst.overlap_m, fall.overlap_m);
  }
  fmt::print("{} falls: made over dissipated up to {:.1e}, overlap up to {:.1e} m\n", seeds, worst.made_over_dissipated,
             worst.overlap_m);
}

/// Corners of which one pressed on the other's face, and the other went into the one's.
TEST(Collapse, FacesThatComeOntoEachOtherAtTheirCornersPressAtBoth) {
  for (const unsigned seed : {36U, 51U}) EXPECT_LE(watched(random_collapse(seed)).overlap_m, 1e-6) << "seed " << seed;
}

/// Corners that a step takes past each other by more than they were apart: 1.4e-6 and 1.1e-6 m before.
TEST(Collapse, OfHundredsOfBlocksMakesNoOverlapEither) {
  constexpr double duration_s = 2;
  for (const unsigned seed : {3U, 26U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    const double friction_deg = 15 + 30 * share(random);
    if (seed % 2 == 0) {
      const std::string heap = test::heap(60 + static_cast<int>(140 * share(random)), seed);
      EXPECT_LE(watched(test::collapse(heap, duration_s, 0, friction_deg)).overlap_m, 1e-6) << "seed " << seed;
      continue;
    }
    const double tilt_deg = 10 + 20 * share(random);
    const double brick_length_m = 0.6 + share(random);
    const int columns = 3 + static_cast<int>(6 * share(random));
    const std::string wall = test::wall(12 + static_cast<int>(20 * share(random)), columns, brick_length_m);
    EXPECT_LE(watched(test::collapse(wall, duration_s, tilt_deg, friction_deg)).overlap_m, 1e-6) << "seed " << seed;
  }
}

/// A corner in a face next to its end, out of which it was to go by the face beside: 6.2e-6 and 2.5e-5 m before.
TEST(Collapse, ACornerLeavesAFaceByTheSideThatItsBlockIsOn) {
  for (const unsigned seed : {48U, 66U}) EXPECT_LE(watched(test::random_fall(seed)).overlap_m, 1e-6) << "seed " << seed;
}

/// A wall that slides shoves bricks that stand: 4.2e-5 and 1.3e-5 before.
TEST(Collapse, WhatMovesPaysForWhatItPushes) {
  for (const unsigned seed : {73U, 74U}) {
    EXPECT_LE(watched(test::random_fall(seed)).made_over_dissipated, 1e-6) << "seed " << seed;
  }
}

/// Forces in a jam grew from step to step and lifted the stones: 5.8e-4 of the energy dissipated before.
TEST(Collapse, AJamDoesNotLiftWhatItHolds) {
  EXPECT_LE(watched(test::collapse(test::heap(25, 5), 2, 0, 60)).made_over_dissipated, 1e-5);
}

/// No contact parts them: on the ground each seems to pass the other.
TEST(Collapse, TipsThatSlideOnTheSameGroundDoNotGoIntoEachOther) {
  EXPECT_LE(watched(test::collapse(test::heap(60, 1), 1.6, 0, 20)).overlap_m, 1e-7) << "2.2e-6 m before";
}

/// Two tips under a tenth of a radian seemed to lie on each other's undersides, and went through each other.
TEST(Collapse, WedgesHoweverSharpDoNotGoIntoEachOther) {
  for (const double angle_deg : {1.0, 3.0, 5.0, 8.0}) {
    const double length_m = 0.3 / std::tan(angle_deg * std::numbers::pi / 180);
    const auto wedge = [&](const char* name, double tip_m, double end_m) {
      return fmt::format(
          "[[block]]\nname = \"{}\"\nmaterial = \"stone\"\nvertices_m = [[{}, 0], [{}, 0], [{}, 0.3]]\n"
          "initial_velocity_m_per_s = [{}, 0]\n",
          name, tip_m, end_m, end_m, tip_m < 0 ? 8 : -8);
    };
    const std::string floor =
        "[[block]]\nname = \"floor\"\nmaterial = \"stone\"\nfixed = true\nvertices_m = [[-60, -1], [60, -1], [60, 0], "
        "[-60, 0]]\n";
    const std::string left = wedge("a", -0.025, -0.025 - length_m);
    const std::string right = wedge("b", 0.025, 0.025 + length_m);
    EXPECT_LE(watched(test::collapse(floor + left + right, 0.3, 0, 5)).overlap_m, 1e-7) << angle_deg;
  }
}

TEST(Collapse, SweepsTakeOverSoonWhereNewtonsMethodLeadsAway) {
  scene::Scene moves = test::collapse(test::wall(10, 2, 1), 0.01, 20, 30);
  for (scene::Block& block : moves.blocks)
    block.initial_velocity_m_per_s.x() = block.fixed ? 0 : 0.1;  // it does not rest
  solid::Solid wall(moves);
  wall.advance(0, 0.01, {});
  EXPECT_GT(wall.counts().sweeps, 0);
  EXPECT_LE(wall.counts().iterations, 5) << "40 solutions before";
}

}  // namespace
}  // namespace blockweir::solid::collapse_test
