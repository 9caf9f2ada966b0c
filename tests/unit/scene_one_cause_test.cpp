// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// One cause has one error: what follows from it is not reported beside it.
#include <gtest/gtest.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_one_cause_test {
namespace {

using namespace blockweir::scene;
using sample::expect_error;

std::string scene_of(const std::string& sections) {
  return "water.upstream_level_m = 0.5\nmaterial.m = { youngs_modulus_pa = 1e9, poissons_ratio = 0.2, "
         "density_kg_per_m3 = 2000 }\nanalysis.duration_s = 1\n" +
         sections;
}

std::string wall(const std::string& rows) {
  return "[[wall]]\nname = \"w\"\nmaterial = \"m\"\nbrick_length_m = 0.5\nbrick_height_m = 0.25\nfixed_base = true\n"
         "columns = 3\nrows = " +
         rows + "\n";
}

const std::string joint = "[[joints]]\nname = \"base\"\nbetween = [\"w1-1\", \"w2-1\"]\n";

TEST(SceneOneCause, AWallThatIsNotMadeTakesNeitherItsLevelNorItsNamesWithIt) {
  expect_error(scene_of(wall("-3") + joint), 11, {"rows in [[wall]] \"w\" is -3", "from 1 to 100000"});
  expect_error(scene_of(wall("90000") + joint), 4, {"has 270000 blocks", "at most 100000"});
}

TEST(SceneOneCause, ANameThatNoGeneratorMakesIsStillFound) {
  expect_error(scene_of(wall("3") + "[[joints]]\nname = \"base\"\nbetween = [\"w1-1\", \"w9-1\"]\n"), 14,
               {"names no block: \"w9-1\""});
}

TEST(SceneOneCause, AHeapInAWallIsOneOverlap) {
  const std::string heap = "[[heap]]\nname = \"h\"\nmaterial = \"m\"\nwidth_m = 1.5\nsize_m = 0.4\nbox = false\n";
  expect_error(scene_of(wall("8") + heap), 12,
               {"blocks \"w1-1\" and \"h1\" overlap by", "more pairs of the blocks of lines 4 and 12",
                "move one of the two, by its origin_m or its outline"});
}

TEST(SceneOneCause, AWrongLevelIsNotSaidToBeMissing) {
  const auto wrong = sample::errors(
      sample::with("[water]", "[ice]\nthickness_m = 0.5\nthrust_n_per_m = 1e5\n[water]\nupstream_level_m = \"high\"",
                   sample::with("upstream_level_m", "downstream_level_m")));
  EXPECT_THAT(wrong, testing::Not(testing::Contains(testing::HasSubstr("without a reservoir"))));
  EXPECT_THAT(wrong, testing::Contains(testing::HasSubstr("upstream_level_m")));
}

TEST(SceneOneCause, ARefusedFrictionAngleIsNotReplacedByTheDefaultInComparisons) {
  const std::string blocks =
      "[[block]]\nname = \"a\"\nmaterial = \"m\"\nfixed = true\nvertices_m = [[0, 0], [2, 0], [2, 1], [0, 1]]\n"
      "[[block]]\nname = \"b\"\nmaterial = \"m\"\nvertices_m = [[0, 1], [2, 1], [2, 2], [0, 2]]\n"
      "[[joints]]\nname = \"j\"\nbetween = [\"a\", \"b\"]\nresidual_friction_angle_deg = 36\n";
  const std::string law =
      "[joint]\nfriction_angle_deg = 95\nresidual_friction_angle_deg = 34\ndilation_angle_deg = 32\ncohesion_pa = 1e4\n"
      "tension_strength_pa = 1.5e4\n";
  try {
    read_text(scene_of(law + blocks), "s.toml");
    FAIL() << "read";
  } catch (const SceneError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U) << error.what();
    EXPECT_THAT(error.diagnostics()[0].text(), testing::HasSubstr("friction_angle_deg in [joint] is 95"));
  }
}

TEST(SceneOneCause, BlocksThatOverlapAreNotSaidToBeApart) {
  const std::string two =
      "[[block]]\nname = \"a\"\nmaterial = \"m\"\nfixed = true\nvertices_m = [[0, 0], [2, 0], [2, 1], [0, 1]]\n"
      "[[block]]\nname = \"b\"\nmaterial = \"m\"\nvertices_m = [[0, 0.9], [2, 0.9], [2, 2], [0, 2]]\n";
  expect_error(scene_of(two + "[[joints]]\nname = \"j\"\nbetween = [\"a\", \"b\"]\nuplift = \"full\"\n"), 9,
               {"blocks \"a\" and \"b\" overlap by 0.2 m2"});
}

TEST(SceneOneCause, ALevelIsToldInSixDigits) {
  const std::string scene =
      sample::with("0.5", "3.1234567890123", scene_of(wall("3")).substr(0, 30)) + scene_of(wall("3")).substr(30);
  expect_error(scene, 1, {"upstream_level_m reaches 3.12346 m, above the structure's top at 0.75 m"});
}

TEST(SceneOneCause, AHeapTellsTheLimitThatItHas) {
  for (const char* blocks : {"100001", "3000000"}) {
    expect_error(scene_of("[[heap]]\nname = \"h\"\nmaterial = \"m\"\nwidth_m = 2\nsize_m = 0.4\nblocks = " +
                          std::string(blocks) + "\n"),
                 9, {"blocks in [[heap]] \"h\" is", "a whole number from 1 to 100000"});
  }
}

TEST(SceneOneCause, AnEmptySetIsToldWhatItNeeds) {
  expect_error(scene_of(wall("3") + "[[variant]]\nname = \"none\"\nset = []\n"), 14,
               {"set in [[variant]] \"none\" is an empty list", "expected at least one text \"key=value\"",
                "state what it changes, such as set = [\"joint.friction_angle_deg=25\"]"});
}

}  // namespace
}  // namespace blockweir::scene_one_cause_test
