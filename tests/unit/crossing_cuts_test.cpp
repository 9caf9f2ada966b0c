// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Cuts that cross: what slides along one of them past the crossing meets a block that it had no joint with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid::crossing_cuts_test {
namespace {

/// Four quarters of a square on a friction of 60 degrees: the level cut has 14, the upright one 20 and a bond.
scene::Scene quarters(const std::string& more = "") {
  return scene::read_text(R"(
[analysis]
duration_s = 1
[material.rock]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[joint]
friction_angle_deg = 60
[section]
material = "rock"
outline_m = [[0, 0], [4, 0], [4, 4], [0, 4]]
held_points_m = [[1, 0], [3, 0]]
[[cut]]
name = "level"
points_m = [[-1, 2], [5, 2]]
friction_angle_deg = 14
[[cut]]
name = "upright"
points_m = [[2, -1], [2, 5]]
friction_angle_deg = 20
cohesion_pa = 1e5
)" + more,
                          "s.toml", {})
      .scene;
}

/// Friction angle [deg] of the contacts between two blocks once the first is moved to the right by `slip_m`.
std::vector<double> angles_between(const scene::Scene& scene, const std::string& a, const std::string& b,
                                   double slip_m) {
  const Solid solid(scene);
  const auto index = [&](const std::string& name) {
    const auto found = std::find_if(scene.blocks.begin(), scene.blocks.end(), [&](auto& s) { return s.name == name; });
    return static_cast<int>(found - scene.blocks.begin());
  };
  std::vector<Placement> placements = solid.placements();
  Vector6 moved = Vector6::Zero();
  moved[0] = slip_m;
  const auto mover = static_cast<std::size_t>(index(a));
  placements[mover] = Placement(solid.blocks()[mover].centroid, moved);
  ContactSearch search(solid.parts(), solid.laws(), 2, 0.01, 0.1);
  std::vector<ContactPoint> contacts;
  search.update(placements, contacts);
  std::vector<double> angles;
  for (const ContactPoint& c : contacts) {
    if (c.pair() != std::pair<int, int>(std::minmax({index(a), index(b)}))) continue;
    const JointProperties& law = solid.laws()[c.law];
    angles.push_back(std::atan(solid.laws().strength(c, c.force.x()).friction) * 180 / std::numbers::pi);
    EXPECT_EQ(law.joint, -1) << "none of the cut's joints, which results speak of";
    EXPECT_EQ(law.cohesion_pa, 0);
  }
  return angles;
}

/// s3 lies over s1 and slides over s2, which it touched in a point.
TEST(CrossingCuts, WhatSlidesPastTheCrossingHasTheLawOfTheCutThatItSlidesAlong) {
  const auto angles = angles_between(quarters(), "s3", "s2", 0.3);
  ASSERT_FALSE(angles.empty());
  for (const double angle : angles) EXPECT_NEAR(angle, 14, 1e-9);
}

TEST(CrossingCuts, APairThatTheSceneNamesHasItsOwnLaw) {
  const Solid solid(quarters("[[joints]]\nname = \"own\"\nbetween = [\"s2\", \"s3\"]\nfriction_angle_deg = 30\n"));
  EXPECT_NEAR(solid.laws()[solid.laws().between(1, 2)].friction, std::tan(std::numbers::pi / 6), 1e-12);
}

TEST(CrossingCuts, EachPlaneHoldsOnItsLineWhateverTheLawOfThePair) {
  const auto scene = quarters("[[joints]]\nname = \"own\"\nbetween = [\"s2\", \"s3\"]\nfriction_angle_deg = 30\n");
  const auto angles = angles_between(scene, "s3", "s2", 0.3);
  ASSERT_FALSE(angles.empty());
  for (const double angle : angles) EXPECT_NEAR(angle, 14, 1e-9);
}

TEST(CrossingCuts, EdgesThatNoCutMadeHaveNone) {
  const scene::Scene scene = quarters();
  const Solid solid(scene);
  const auto plane_from = [&](const geometry::Point& from) {
    const auto& outline = scene.blocks[0].vertices;
    const auto edge = std::find(outline.begin(), outline.end(), from) - outline.begin();
    return solid.laws().plane_of(0, static_cast<int>(edge), 0, 1);
  };
  EXPECT_EQ(plane_from({0, 0}), 0) << "the outline's lower side";
  EXPECT_NEAR(solid.laws()[plane_from({2, 0})].friction, std::tan(20 * std::numbers::pi / 180), 1e-12) << "upright";
  EXPECT_NEAR(solid.laws()[plane_from({2, 2})].friction, std::tan(14 * std::numbers::pi / 180), 1e-12) << "level";
}

}  // namespace
}  // namespace blockweir::solid::crossing_cuts_test
