// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Cuts, sets of joints and regions that leave nothing in the section are said.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_cut_effects_test {
using namespace blockweir::scene;
using sample::expect_error;
using sample::expect_warning;
using sample::warnings;
using testing::IsEmpty;

namespace {

/// A square of 4 m on the ground, cut at mid-height; what follows begins in line 22.
const std::string section = R"([analysis]
duration_s = 1
[material.m]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[joint]
friction_angle_deg = 30
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-1, -1], [5, -1], [5, 0], [-1, 0]]
[section]
material = "m"
outline_m = [[0, 0], [4, 0], [4, 4], [0, 4]]
[[cut]]
name = "lift"
points_m = [[-1, 2], [5, 2]]
cohesion_pa = 1e5
bonded_length_m = 3
)";

TEST(CutEffects, ACutThatPartsBlocksIsSound) {
  EXPECT_THAT(warnings(section), IsEmpty());
}

TEST(CutEffects, ACutThatPartsNothingIsAnError) {
  for (const char* points : {"[[5, 1], [6, 1]]", "[[-1, 1], [3, 1]]", "[[0, 0], [0, 4]]"}) {
    expect_error(section + "[[cut]]\nname = \"crack\"\npoints_m = " + points + "\n", 22,
                 {"[[cut]] \"crack\" has no effect: it parts no block of the section"});
  }
}

TEST(CutEffects, ACutOnAnotherHasALawThatNoJointHas) {
  expect_warning(section + "[[cut]]\nname = \"crack\"\npoints_m = [[0, 2], [4, 2]]\n", 22,
                 {"the law of [[cut]] \"crack\" has no effect: other cuts lie on it"});
}

/// All that rests on the lower metre rests on a joint of this name.
TEST(CutEffects, ACutAlongTheOutlineOfARegionGivesItItsLaw) {
  const std::string lower = "[[region]]\nmaterial = \"m\"\noutline_m = [[0, 0], [4, 0], [4, 1], [0, 1]]\n";
  const std::string upper = "[[region]]\nmaterial = \"m\"\noutline_m = [[0, 1], [4, 1], [4, 4], [0, 4]]\n";
  for (const std::string& regions : {lower, lower + upper}) {
    for (const char* points : {"[[0, 1], [4, 1]]", "[[-1, 1], [9, 1]]"}) {
      const ReadScene read =
          read_text(section + regions + "[[cut]]\nname = \"base\"\ncohesion_pa = 7e4\npoints_m = " + points, "s.toml");
      EXPECT_THAT(read.warnings, IsEmpty());
      EXPECT_EQ(std::count_if(read.scene.joints.begin(), read.scene.joints.end(),
                              [](const Joint& joint) { return joint.set == "base" && joint.law.cohesion_pa == 7e4; }),
                1);
    }
  }
}

TEST(CutEffects, ACutAlongTheShorterPartOfARegionsOutlineIsAnError) {
  expect_error(section +
                   "[[region]]\nmaterial = \"m\"\noutline_m = [[0, 0], [4, 0], [4, 1.5], [3, 1.5], [3, 1], [0, 1]]\n"
                   "[[cut]]\nname = \"base\"\ncohesion_pa = 7e4\npoints_m = [[3, 1.5], [4, 1.5]]\n",
               25,
               {"the law of [[cut]] \"base\" has no effect: its two blocks meet along a longer part of a [[region]]'s "
                "outline",
                "lead the cut along all of that boundary"});
}

/// A crack parts what stands on the base in two: of these one meets the step below along a longer part than the base.
TEST(CutEffects, ACutAlongAShorterPartOfOneBoundaryIsAnErrorThoughItActsElsewhere) {
  const std::string step =
      sample::with("bonded_length_m = 3", "", section) +
      "[[region]]\nmaterial = \"m\"\noutline_m = [[0, 0], [4, 0], [4, 1], [1, 1], [1, 2], [0, 2]]\n"
      "[[cut]]\nname = \"base\"\nfriction_angle_deg = 12\npoints_m = [[1, 1], [4, 1]]\n"
      "[[cut]]\nname = \"crack\"\npoints_m = [[X, -1], [X, 2]]\n";
  expect_error(sample::with("[X, -1], [X, 2]", "[1.9, -1], [1.9, 2]", step), 25,
               {"[[cut]] \"base\" has no effect along 0.9 m between blocks \"s1\" and \"s3\": a longer part of their "
                "boundary is a [[region]]'s outline, which has the law of [joint]",
                "part one of the blocks where the cut ends"});
  EXPECT_THAT(warnings(sample::with("[X, -1], [X, 2]", "[2.1, -1], [2.1, 2]", step)), IsEmpty());
}

TEST(CutEffects, SomeLinesOfANamePartNothing) {
  const std::string first = "[[cut]]\nname = \"crack\"\ndrawn = true\npoints_m = [[0, 1], [4, 1]]\n";
  expect_warning(section + first + "[[cut]]\nname = \"crack\"\ndrawn = true\npoints_m = [[0, 3], [3, 3]]\n", 26,
                 {"1 of 2 lines of [[cut]] \"crack\" parts no block of the section, which has no effect"});
}

TEST(CutEffects, ABondLongerThanTheJointOfItsCutIsAnError) {
  expect_error(sample::with("bonded_length_m = 3", "bonded_length_m = 4.5", section), 21,
               {"bonded_length_m 4.5 in [[cut]] \"lift\" is longer than its joints, 4 m at most"});
}

TEST(CutEffects, ASetOfJointsBesideTheSectionIsAnError) {
  const std::string set = "[[joint_set]]\nname = \"far\"\ndip_deg = 0\noffset_m = 2.5\nspacing_m = 50\n";
  EXPECT_THAT(warnings(section + set), IsEmpty());
  expect_error(sample::with("offset_m = 2.5", "offset_m = 20", section + set), 22,
               {"[[joint_set]] \"far\" has no effect: it parts no block"});
  expect_warning(sample::with("offset_m = 2.5", "offset_m = 20\npersistence = 0.5\ntrace_length_m = 1", section + set),
                 22, {"[[joint_set]] \"far\" has no effect"});
}

TEST(CutEffects, ARegionWithoutABlockIsAnError) {
  const std::string region = "[[region]]\nmaterial = \"m\"\noutline_m = ";
  EXPECT_THAT(warnings(section + region + "[[0, 0], [4, 0], [4, 1], [0, 1]]\n"), IsEmpty());
  expect_error(section + region + "[[6, 0], [7, 0], [7, 1], [6, 1]]\n", 22,
               {"[[region]] has no effect: no block of the section lies in it"});
}

}  // namespace
}  // namespace blockweir::scene_cut_effects_test
