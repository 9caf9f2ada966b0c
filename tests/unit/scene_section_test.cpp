// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// A section cut into blocks by the scene: names, materials, joints, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bridge/geometry/joint_set.hpp"
#include "bridge/geometry/polygon.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_section_test {
using namespace blockweir::scene;
using sample::errors;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

const std::string head = R"([analysis]
duration_s = 1
[material.concrete]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[material.rock]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2600
[joint]
friction_angle_deg = 35
)";
const std::string section = R"([section]
material = "concrete"
outline_m = [[0, 0], [4, 0], [4, 4], [0, 4]]
[[region]]
material = "rock"
fixed = true
outline_m = [[0, 0], [4, 0], [4, 1], [0, 1]]
)";

Scene scene_of(const std::string& cuts) {
  return read_text(head + section + cuts, "s.toml").scene;
}

TEST(SceneSection, RegionsGiveMaterialAndHoldTheirBlocks) {
  const Scene scene = scene_of("");
  ASSERT_THAT(scene.blocks, SizeIs(2));
  EXPECT_EQ(scene.blocks[0].name, "s1");
  EXPECT_TRUE(scene.blocks[0].fixed);
  EXPECT_EQ(scene.materials[static_cast<std::size_t>(scene.blocks[0].material)].name, "rock");
  EXPECT_FALSE(scene.blocks[1].fixed);
  EXPECT_EQ(scene.materials[static_cast<std::size_t>(scene.blocks[1].material)].name, "concrete");
}

TEST(SceneSection, ACutNamesItsJointAndGivesItsLaw) {
  const Scene scene = scene_of("[[cut]]\nname = \"crack\"\npoints_m = [[0, 3], [4, 2]]\ncohesion_pa = 1e5\n");
  ASSERT_THAT(scene.blocks, SizeIs(3));
  ASSERT_THAT(scene.joints, SizeIs(2));
  const Joint& crack = scene.joints[1];
  EXPECT_EQ(crack.name, "crack");
  EXPECT_EQ(crack.between, (std::array{1, 2}));
  EXPECT_EQ(crack.law.cohesion_pa, 1e5);
  EXPECT_EQ(crack.law.friction_angle_deg, 35);
}

TEST(SceneSection, NamesThatSetCannotTellApartAreRefusedWithBothLines) {
  const std::string cut = "[[cut]]\nname = \"lift\"\npoints_m = [[0, 3], [4, 3]]\n";
  const std::string set = "[[joint_set]]\nname = \"bedding\"\ndip_deg = 0\nspacing_m = 1\n";
  EXPECT_THAT(errors(head + section + cut + cut + "[water]\nupstream_level_m = 3\n"),  // no other error follows
              testing::ElementsAre(HasSubstr("s.toml:24: error: a second cut is called \"lift\", as that of line 20")));
  EXPECT_THAT(errors(head + section + set + set), testing::Contains(HasSubstr("\"bedding\", as that of line 20")));
}

/// What makes blocks is named, as no line of the file has their names.
TEST(SceneSection, ABlockWithTheNameOfAPieceIsRefusedWithWhatMakesThat) {
  const std::string block =
      "[[block]]\nname = \"s1\"\nmaterial = \"rock\"\nfixed = true\nvertices_m = [[90, 0], [91, 0], [91, 1]]\n";
  const int line = static_cast<int>(std::count(head.begin(), head.end(), '\n')) + 1;
  EXPECT_THAT(
      errors(head + section + block),
      testing::Contains(HasSubstr("a second block is called \"s1\", as one that [section] of line " +
                                  std::to_string(line) + " makes; expected names that differ; rename the block")));
}

/// As lines on one layer of a drawing, in the scene of a run.
TEST(SceneSection, DrawnCutsOfOneNameAreSetTogether) {
  const std::string cut = "[[cut]]\nname = \"lift\"\ndrawn = true\npoints_m = ";
  const Scene scene = read_text(head + section + cut + "[[0, 3], [4, 3]]\n" + cut + "[[0, 2], [4, 2]]\n", "s.toml",
                                {"cut.lift.friction_angle_deg=20"})
                          .scene;
  ASSERT_THAT(scene.joints, SizeIs(3));
  const auto has_it = [](const Joint& joint) { return joint.law.friction_angle_deg == 20; };
  EXPECT_EQ(std::count_if(scene.joints.begin(), scene.joints.end(), has_it), 2);
}

TEST(SceneSection, JointsOfASetAreNamedByTheirBlocks) {
  const Scene scene =
      scene_of("[[joint_set]]\nname = \"bedding\"\ndip_deg = 0\nspacing_m = 1\nfriction_angle_deg = 20\n");
  ASSERT_THAT(scene.blocks, SizeIs(4));
  EXPECT_EQ(scene.joints.back().name, "bedding, s3 and s4");
  EXPECT_EQ(scene.joints.back().law.friction_angle_deg, 20);
  EXPECT_EQ(scene.joints.back().law.residual_friction_angle_deg, 20);
}

TEST(SceneSection, ASetOfJointsMayStayInARegion) {
  const auto scene_with = [](const std::string& set) {
    const std::string named = sample::with("[[region]]", "[[region]]\nname = \"rock\"", section);
    return read_text(head + named + "[[joint_set]]\nname = \"joints\"\nregion = \"rock\"\n" + set, "s.toml").scene;
  };
  const auto of_rock = [](const Scene& scene) {
    return std::count_if(scene.blocks.begin(), scene.blocks.end(), [](const Block& b) { return b.fixed; });
  };
  const Scene upright = scene_with("dip_deg = 90\nspacing_m = 1\noffset_m = 0.5\n");
  EXPECT_EQ(of_rock(upright), 5);
  EXPECT_THAT(upright.blocks, SizeIs(6));  // the dam is one block still
  for (const double dip_deg : {-60.0, 37.0, 71.0}) {
    const Scene leaning = scene_with(fmt::format("dip_deg = {}\nspacing_m = 0.6\n", dip_deg));
    EXPECT_GT(of_rock(leaning), 4) << dip_deg;
    EXPECT_EQ(static_cast<long>(leaning.blocks.size()) - of_rock(leaning), 1) << dip_deg;
  }
}

TEST(SceneSection, ASetOfJointsInNoRegionIsRefused) {
  EXPECT_THAT(errors(head + section + "[[joint_set]]\nname = \"j\"\ndip_deg = 0\nspacing_m = 1\nregion = \"rok\"\n"),
              testing::Contains(HasSubstr("names no region: \"rok\"")));
}

TEST(SceneSection, BlocksOfOnesOwnStandBesideIt) {
  const Scene scene = scene_of(
      "[[block]]\nname = \"cap\"\nmaterial = \"rock\"\nvertices_m = [[0, 4], [4, 4], [2, 5]]\n"
      "[[joints]]\nname = \"cap joint\"\nbetween = [\"s2\", \"cap\"]\n");
  EXPECT_EQ(scene.blocks.back().name, "cap");
  EXPECT_EQ(scene.joints.back().between, (std::array{1, 2}));
}

void expect_refusal(const std::string& cuts, const std::vector<std::string>& words) {
  const auto found = errors(head + section + cuts);
  ASSERT_THAT(found, SizeIs(1)) << cuts;
  for (const std::string& word : words) EXPECT_THAT(found[0], HasSubstr(word));
}

TEST(SceneSection, WhatIsWrongIsNamed) {
  expect_refusal("[[cut]]\nname = \"ring\"\npoints_m = [[1, 2], [2, 2], [2, 3], [1, 2]]\n",
                 {"a block encloses a hole or a closed line at (", "add a [[cut]] from there"});
  expect_refusal("[[cut]]\nname = \"c\"\npoints_m = [[1, 2]]\n", {"a list of 2 to 10000 points"});
  expect_refusal("[[joint_set]]\nname = \"b\"\ndip_deg = 0\nspacing_m = 1e-5\n", {"would draw about", "spacing_m"});
  const auto set = [](double dip_deg, double spacing_m, const char* name = "b") {
    return fmt::format("[[joint_set]]\nname = \"{}\"\ndip_deg = {}\nspacing_m = {}\n", name, dip_deg, spacing_m);
  };
  expect_refusal(set(0, 1) + "offset_m = 1e300\n", {"offset_m", "a number within 1e7"});
  expect_refusal(set(0, 1e9) + "persistence = 0.5\ntrace_length_m = 1e-300\n", {"would draw about"});
  expect_refusal(set(10, 0.003) + set(10, 0.003, "c") + set(10, 0.003, "d"),
                 {"the section has ", " edges, cuts and joints", "at most 5000"});
  expect_refusal(set(10, 0.02) + set(80, 0.02, "c"),
                 {"cross too often", "at most 20000", "spacing of its joints larger"});
  expect_refusal("[[joint_set]]\nname = \"b\"\ndip_deg = 100\nspacing_m = 1\n", {"dip_deg", "an angle from -90 to 90"});
  expect_refusal("[[joint_set]]\nname = \"b\"\ndip_deg = 0\nspacing_m = 1\npersistence = 0.5\n",
                 {"has no \"trace_length_m\""});
  expect_refusal("[[region]]\nmaterial = \"rock\"\noutline_m = [[0, 0], [2, 2], [2, 0], [0, 2]]\n",
                 {"the outline of a region crosses itself"});
  EXPECT_THAT(errors(head + "[[cut]]\nname = \"c\"\npoints_m = [[1, 2], [3, 4]]\n"),
              testing::Contains(HasSubstr("cut a section, and there is none")));
}

TEST(SceneSection, HolesThatOverlapOrReachOutAreRefused) {
  const auto with_holes = [](const std::string& holes) {
    return head + sample::with("[0, 4]]\n", "[0, 4]]\nholes_m = [" + holes + "]\n", section);
  };
  const std::string above = "[[1, 4], [2, 4], [2, 5], [1, 5]]";  // a common edge, on the wrong side of it
  const std::string across = "[[1, 3], [2, 3], [2, 5], [1, 5]]";
  const std::string beyond = "[[1, 5], [2, 5], [2, 6], [1, 6]]";
  const std::string notch = "[[1, 3], [2, 3], [2, 4], [1, 4]]";
  for (const std::string& holes : {above, across, beyond, notch, notch + ", " + notch}) {
    sample::expect_error(with_holes(holes), 16, {"the blocks of the section have", "holes inside the outline"});
  }
  const std::string way_out = "[[cut]]\nname = \"c\"\npoints_m = [[0, 2.5], [4, 2.5]]\n";
  EXPECT_THAT(errors(with_holes("[[1, 2], [2, 2], [2, 3], [1, 3]]") + way_out), IsEmpty());
}

TEST(JointSets, OneThatIsFarOffOrAllBridgesEnds) {
  blockweir::geometry::JointSet set{.dip_deg = 0, .spacing_m = 1, .offset_m = 1e300};
  EXPECT_LE(blockweir::geometry::joints_of(set, {0, 0}, {1, 1}, 0).size(), 4U);
  set = {.dip_deg = 0, .spacing_m = 1, .persistence = 1e-320, .trace_length_m = 1};
  EXPECT_LE(blockweir::geometry::joints_of(set, {0, 0}, {1, 1}, 0).size(), 4U);
}

TEST(JointSets, KeepSpacingAndPersistence) {
  using namespace blockweir::geometry;
  JointSet set{.dip_deg = 30, .spacing_m = 2, .persistence = 0.6, .trace_length_m = 3, .seed = 5};
  double length = 0;
  double whole = 0;
  const auto lines = joints_of(set, {0, 0}, {400, 400}, 0);
  for (const Line& line : lines) length += (line.points[1] - line.points[0]).norm();
  std::set<long> heights;
  for (const Line& line : lines) {
    const double height = std::sin(M_PI / 6) * line.points[0].x() + std::cos(M_PI / 6) * line.points[0].y();
    EXPECT_NEAR(std::remainder(height, 2), 0, 1e-9);
    heights.insert(std::lround(height / 2));
  }
  whole = static_cast<double>(heights.size()) * std::sqrt(2.0) * 400;
  EXPECT_NEAR(length / whole, 0.6, 0.02);
  EXPECT_EQ(lines.size(), joints_of(set, {0, 0}, {400, 400}, 0).size());
  EXPECT_EQ(lines[7].points, joints_of(set, {0, 0}, {400, 400}, 0)[7].points);
  set.seed = 6;
  EXPECT_NE(lines[7].points, joints_of(set, {0, 0}, {400, 400}, 0)[7].points);
}

}  // namespace
}  // namespace blockweir::scene_section_test
