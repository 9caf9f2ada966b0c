// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_reservoir bridge_scene_read
// The reservoir's mesh follows a dam that slides: only where it moved, with the pressures of a mesh made anew.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/unit/reservoir_dam.hpp"

namespace blockweir::reservoir::reservoir_mesh_follows_test {
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

scene::Scene with_windows(double window_s, scene::Scene scene) {
  scene.coupling.window_s = window_s;
  return scene;
}

std::string basin(const std::string& of_mesh, const std::string& more = "") {
  return "[fluid]\nmodel = \"reservoir\"\nreservoir = { surface = \"waves\", upstream_wall_m = -50, element_ratio = "
         "0.5" +
         of_mesh + " }\n" + more;
}

/// 0.5 m/s2 for 4 s, then 2 m/s: 36 m in 20 s.
TEST(ReservoirFollows, WavesInABasinThatDriftsAreThoseInItsOwnFrame) {
  const std::string shaken =
      "[base_motion]\nacceleration_x_m_per_s2 = { table = [[0, 0.5], [4, 0.5], [4.000001, 0]] }\nform = ";
  const scene::Scene still_ground = with_windows(0.2, dam_of_two(basin("", shaken + "\"inertia\"\n")));
  for (const std::string of_mesh : {"", ", move_tolerance = 0"}) {
    const scene::Scene drifting = with_windows(0.2, dam_of_two(basin(of_mesh, shaken + "\"support\"\n")));
    ReservoirModel one(still_ground);
    ReservoirModel other(drifting);
    wire::Load a;
    wire::Load b;
    double largest = 0;
    for (int i = 0; i <= 100; ++i) {
      const double t = 0.2 * i;
      const double x = i < 20 ? 0.25 * t * t : 4 + 2 * (t - 4);
      wire::Motion motion;
      motion.displacement.own().assign(3, {x, 0, 0, 0, 0, 0});
      motion.velocity.own().assign(3, {i < 20 ? 0.5 * t : 2, 0, 0, 0, 0, 0});
      one.advance(moved(0, 0), t, a);
      other.advance(motion, t, b);
      largest = std::max(largest, std::abs(thrust(a) - still));
      EXPECT_NEAR(thrust(a), thrust(b), 0.01 * 0.5 * added) << t << of_mesh;
    }
    EXPECT_GT(largest, 0.5 * added);
  }
}

/// The wall of a basin as a wavemaker, by 0.02 of the depth: the mean of its thrust stays where it is on a mesh at
/// rest.
TEST(ReservoirFollows, AWavemakerDoesNotRaiseItsBasin) {
  const scene::Scene at_rest = with_windows(0.2, dam_of_two(basin(", move_tolerance = 0.1")));
  for (const std::string of_mesh : {"", ", move_tolerance = 0"}) {
    const scene::Scene follows = with_windows(0.2, dam_of_two(basin(of_mesh)));
    ReservoirModel one(at_rest);
    ReservoirModel other(follows);
    wire::Load a;
    wire::Load b;
    constexpr double rate = 0.858;  // rad/s
    double mean = 0;
    double largest = 0;
    for (int i = 0; i < 219; ++i) {  // six periods
      const double phase = 0.2 * rate * i;
      const wire::Motion motion = moved(0.4 * (1 - std::cos(phase)), 0.4 * rate * std::sin(phase));
      one.advance(motion, 0.2 * i, a);
      other.advance(motion, 0.2 * i, b);
      largest = std::max(largest, std::abs(thrust(a) - still));
      if (i >= 183) mean += (thrust(b) - thrust(a)) / 36;  // the last of them
    }
    EXPECT_LT(std::abs(mean), 0.05 * largest) << of_mesh;
  }
}

}  // namespace
}  // namespace blockweir::reservoir::reservoir_mesh_follows_test
