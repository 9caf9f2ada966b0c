// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir bridge_scene_read
// The reservoir's mesh follows a dam that slides: only where it moved, with the pressures of a mesh made anew.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/unit/reservoir_dam.hpp"

namespace blockweir::reservoir {
namespace {

TEST(ReservoirFollows, WavesGoOnAsTheMeshFollowsTheBlocks) {
  const scene::Scene kept = dam_of_two(
      "[fluid]\nmodel = \"reservoir\"\nreservoir = { surface = \"waves\", compressible = true, bottom_reflection = 0.8 "
      "}\n");
  const scene::Scene anew = dam_of_two(
      "[fluid]\nmodel = \"reservoir\"\nreservoir = { surface = \"waves\", compressible = true, bottom_reflection = "
      "0.8, "
      "move_tolerance = 0 }\n");
  ReservoirModel one(kept);
  ReservoirModel other(anew);
  wire::Load a;
  wire::Load b;
  double largest = 0;
  for (int i = 0; i < 60; ++i) {
    const double speed = i < 20 ? 0.01 * i : 0.2;  // 1 m/s2, then none
    const wire::Motion motion = moved(i < 20 ? 5e-5 * i * i : 0.02 + 0.002 * (i - 20), speed);
    one.advance(motion, 0.01 * i, a);
    other.advance(motion, 0.01 * i, b);
    largest = std::max(largest, std::abs(thrust(a) - still));
    EXPECT_NEAR(thrust(a), thrust(b), 0.02 * added) << i;
  }
  EXPECT_GT(largest, 0.8 * added);
  EXPECT_GT(std::abs(thrust(a) - still), 0.01 * added);  // it has not come to rest when the dam has no acceleration
}

TEST(ReservoirFollows, FactorsAreKeptUntilACornerHasMovedAndChangeThePressuresByNoMore) {
  const scene::Scene kept = dam_of_two();
  const scene::Scene anew = dam_of_two("[fluid]\nmodel = \"reservoir\"\nreservoir = { move_tolerance = 0 }\n");
  ReservoirModel one(kept);
  ReservoirModel other(anew);
  wire::Load a;
  wire::Load b;
  for (int i = 0; i < 30; ++i) {
    const wire::Motion motion = moved(0.0015 * i, 0.01 * i);
    one.advance(motion, 0.01 * i, a);
    other.advance(motion, 0.01 * i, b);
    EXPECT_NEAR(thrust(a), thrust(b), 1e-3 * added) << i;
  }
  EXPECT_EQ(one.report().counts.at("reservoir solutions"), 3);
  EXPECT_EQ(other.report().counts.at("reservoir solutions"), 30);
  EXPECT_THAT(one.report().skips, testing::Contains(testing::HasSubstr("mesh and factors in 27 of 30 windows")));
}

}  // namespace
}  // namespace blockweir::reservoir
