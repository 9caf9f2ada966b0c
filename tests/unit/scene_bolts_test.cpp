// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Bolts in a scene: both ends, stiffness, prestress and yield, and what is said of wrong ones.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_bolts_test {
using namespace blockweir::scene;
using sample::errors;
using sample::expect_error;
using sample::text;
using sample::with;

namespace {

/// The sample with a bolt, whose first line is line 56.
std::string bolted(const std::string& keys) {
  return text + "[[bolt]]\nname = \"b\"\nfrom_block = \"top\"\nfrom_m = [1, 3]\n" + keys;
}

TEST(SceneBolt, IsTiedToABlockOrToTheGround) {
  const Scene scene =
      read_text(bolted("to_m = [1, 7]\nyoungs_modulus_pa = 2e11\narea_m2_per_m = 1e-3\n"), "s.toml").scene;
  EXPECT_EQ(scene.bolts[0].blocks, (std::array<int, 2>{2, -1}));
  EXPECT_EQ(scene.bolts[0].stiffness_n_per_m2, 5e7);
  const Scene pair =
      read_text(bolted("to_block = \"base\"\nto_m = [1, 1]\nstiffness_n_per_m2 = 7\nyield_n_per_m = 9\n"), "s.toml")
          .scene;
  EXPECT_EQ(pair.bolts[0].blocks, (std::array<int, 2>{2, 1}));
  EXPECT_EQ(pair.bolts[0].stiffness_n_per_m2, 7);
}

TEST(SceneBolt, FaultsAreNamed) {
  const std::string stiff = "stiffness_n_per_m2 = 1\n";
  expect_error(bolted("to_m = [1, 3]\n" + stiff), 60, {"[[bolt]] \"b\" has no length"});
  expect_error(bolted("to_block = \"top\"\nto_m = [1, 4]\n" + stiff), 60, {"joins a block to itself"});
  expect_error(bolted("to_block = \"base\"\nto_m = [1, 4]\n" + stiff), 61, {"to_m (1, 4)", "outside block \"base\""});
  expect_error(bolted("to_block = \"bsae\"\nto_m = [1, 1]\n" + stiff), 60, {"did you mean \"base\"?"});
  expect_error(bolted("to_m = [1, 7]\n"), 56, {"does not state one stiffness"});
  expect_error(bolted("to_m = [1, 7]\nyoungs_modulus_pa = 1\n"), 56, {"does not state one stiffness"});
  expect_error(bolted("to_m = [1, 7]\nyoungs_modulus_pa = 1\narea_m2_per_m = 1\n" + stiff), 56,
               {"does not state one stiffness"});
  expect_error(bolted("to_m = [1, 7]\nprestress_n_per_m = 2\nyield_n_per_m = 1\n" + stiff), 61,
               {"stressed beyond its yield"});
  expect_error(bolted("to_m = [1, 7]\n" + stiff +
                      "[[bolt]]\nname = \"b\"\nfrom_block = \"top\"\nfrom_m = [1, 3]\nto_m = [1, 7]\n" + stiff),
               63, {"a second bolt is called \"b\""});
}

TEST(SceneBolt, DoesNotEndInTheGroundInsideABlockThatMoves) {
  const std::string stiff = "stiffness_n_per_m2 = 1\n";
  const std::string remedy =
      "state to_block = \"base\", or fixed = true in block \"base\" if it is the ground, or move the point into the "
      "ground";
  expect_error(bolted("to_m = [1, 1]\n" + stiff), 60,
               {"to_m (1, 1) in [[bolt]] \"b\" lies within block \"base\", which moves, and no to_block is stated",
                remedy.c_str()});
  expect_error(bolted("to_m = [1, 3.2]\n" + stiff), 60,
               {"lies within block \"top\"", "move the point into the ground: one end is in this block already"});
  for (const char* sound : {"[1, 1]\nto_block = \"base\"", "[1, 0]", "[1, -0.5]", "[1, 7]"}) {
    EXPECT_THAT(errors(bolted("to_m = " + std::string(sound) + "\n" + stiff)), testing::IsEmpty()) << sound;
  }
}

TEST(SceneBolt, AnEndInTheAirIsWarnedOf) {
  const std::string stiff = "stiffness_n_per_m2 = 1\n";
  const auto told = [&](const std::string& end) {
    const auto all = sample::warnings(bolted("to_m = " + end + "\n" + stiff));
    return std::any_of(all.begin(), all.end(), [](const std::string& warning) {
      return warning.find("is in the air above block \"ground\"") != std::string::npos;
    });
  };
  EXPECT_TRUE(told("[1, 7]"));
  EXPECT_TRUE(told("[-2, 3]"));
  for (const char* sound : {"[1, 0]", "[1, -0.5]", "[4, -3]", "[12, 1]", "[1, 1]\nto_block = \"base\""})
    EXPECT_FALSE(told(sound)) << sound;
}

TEST(SceneBolt, HoldsWhatHangsOnIt) {
  const std::string high =
      with("[[0, 2], [3, 2], [3, 4], [0, 4]]", "[[20, 2], [23, 2], [23, 4], [20, 4]]",
           with("point_m = [0, 4]", "point_m = [20, 4]",
                with("from_m = [3, 2]\nto_m = [3, 4]", "from_m = [23, 2]\nto_m = [23, 4]",
                     with("cohesion_pa = 1e5", "friction_angle_deg = 20", with("[2, 3]", "[1, 2]")))));
  expect_error(high, 23, {"block \"top\" is outside any support"});
  const std::string bolt = "[[bolt]]\nname = \"b\"\nfrom_block = \"top\"\nfrom_m = [21, 3]\nstiffness_n_per_m2 = 1\n";
  EXPECT_THAT(errors(high + bolt + "to_m = [21, 9]\n"), testing::IsEmpty());
  EXPECT_THAT(errors(high + bolt + "to_m = [1, 1]\nto_block = \"base\"\n"), testing::IsEmpty());
}

}  // namespace
}  // namespace blockweir::scene_bolts_test
