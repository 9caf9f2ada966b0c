// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Laws of the water in joints: what is read, and what is refused.
#include <fmt/format.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_uplift_test {
namespace {

using namespace blockweir::scene;
using sample::expect_error;

/// The sample with this law in its crack of 3 m, on lines 30 and following.
std::string crack(const std::string& law) {
  return sample::with("cohesion_pa = 1e5", law);
}

Joint joint(const std::string& law) {
  return read_text(crack(law), "s.toml").scene.joints.front();
}

TEST(SceneUplift, DrainsAndPiezometersAreRead) {
  const Joint drained = joint("uplift = 'drained'\ndrain_m = 1\ndrain_efficiency = 0.5\ndrain_head_m = 2.1");
  ASSERT_TRUE(drained.law.known_heads.drain);
  EXPECT_EQ(*drained.law.known_heads.drain, (Drain{1, 0.5, 2.1}));
  EXPECT_EQ(joint("uplift = 'drained'\ndrain_m = 1\ndrain_head_m = 2.1").law.known_heads.drain->efficiency, 1);
  EXPECT_FALSE(joint("uplift = 'cracked'").law.known_heads.drain);
  const Joint heads = joint("uplift = 'heads'\npiezometers_m = [[1, 2.8], [2, 2.2]]\npiezometers_level_m = 3");
  EXPECT_EQ(heads.law.known_heads.piezometers, (std::vector<Piezometer>{{1, 2.8}, {2, 2.2}}));
  EXPECT_EQ(heads.law.known_heads.level_m, 3);
}

TEST(SceneUplift, ADrainBeyondItsJointIsRefused) {
  expect_error(crack("uplift = 'drained'\ndrain_m = 3.5\ndrain_efficiency = 0.5"), 30,
               {"the drain of joint \"crack\" lies at 3.5 m", "3 m long", "move it"});
  expect_error(crack("uplift = 'heads'\npiezometers_m = [[1, 2.8], [4, 2.2]]\npiezometers_level_m = 3"), 30,
               {"a piezometer of joint \"crack\" lies at 4 m"});
}

/// The crack lies at 2 m, the reservoir rises to 3 m.
TEST(SceneUplift, ADrainAtAHeadThatTheWaterDoesNotHaveIsWarnedOf) {
  const auto warned = [](double head_m, const std::string& pools = "", double efficiency = 1) {
    const std::string law =
        fmt::format("uplift = 'drained'\ndrain_m = 1\ndrain_efficiency = {}\ndrain_head_m = {}", efficiency, head_m);
    std::string scene = crack(law);
    scene.insert(scene.find("[water]\n") + 8, pools);
    return testing::PrintToString(read_text(scene, "s.toml").scene.warnings);
  };
  using testing::HasSubstr;
  EXPECT_THAT(warned(2.1), testing::Not(HasSubstr("drain_head_m")));
  EXPECT_THAT(warned(1.5), HasSubstr("is 1.5 m, below the joint at the drain, 2 m"));
  EXPECT_THAT(warned(4), HasSubstr("is 4 m, above the highest reservoir, 3 m"));
  EXPECT_THAT(warned(2.1, "downstream_level_m = 2.5\n"), HasSubstr("is 2.1 m, below the tailwater at the end, 2.5 m"));
  EXPECT_THAT(warned(1.5, "", 0.01), HasSubstr("below the joint at the drain"));
  for (const double head_m : {1.5, 2.1, 4.0}) {
    EXPECT_THAT(warned(head_m, "downstream_level_m = 2.5\n", 0), testing::Not(HasSubstr("drain_head_m")));
  }
}

TEST(SceneUplift, HalfADrainOrNoneIsRefused) {
  expect_error(crack("uplift = 'drained'"), 30, {"without a drain", "drain_m"});
  expect_error(crack("uplift = 'drained'\ndrain_m = 1"), 31, {"half of a drain", "add drain_efficiency"});
  expect_error(crack("uplift = 'drained'\ndrain_efficiency = 0.5"), 31, {"half of a drain", "add drain_m"});
  expect_error(crack("uplift = 'full'\ndrain_m = 1\ndrain_efficiency = 0.5"), 31, {"has no effect", "\"drained\""});
  expect_error(crack("uplift = 'drained'\ndrain_m = 1\ndrain_efficiency = 60"), 32, {"a number from 0 to 1"});
}

/// A load case cannot leave out what the file says: what if the drains were not there?
TEST(SceneUplift, AnotherLawOfALoadCaseGoesWithoutTheDrainsAndPiezometersOfTheFile) {
  using testing::HasSubstr;
  const std::string drained = crack("uplift = 'drained'\ndrain_m = 1\ndrain_efficiency = 0.5");
  const std::string known = crack("uplift = 'heads'\npiezometers_m = [[1, 2.8]]\npiezometers_level_m = 3");
  for (const std::string law : {"none", "full", "triangular"}) {
    for (const auto& [file, keys] : {std::pair(drained, "drain_m and drain_efficiency"),
                                     std::pair(known, "piezometers_m and piezometers_level_m")}) {
      const Scene read = read_text(file, "s.toml", {"joints.crack.uplift=" + law}).scene;
      const Scene plain = read_text(crack("uplift = '" + law + "'"), "s.toml").scene;
      EXPECT_EQ(read.joints[0].law.uplift, plain.joints[0].law.uplift);
      EXPECT_EQ(read.joints[0].law.known_heads, plain.joints[0].law.known_heads);
      EXPECT_THAT(testing::PrintToString(read.warnings),
                  HasSubstr(keys + std::string(" in [[joints]] \\\"crack\\\" have no effect: its uplift is set to")));
      // A run's folder holds the scene with what was set: it can be run again.
      EXPECT_EQ(read_text(read.text, "s.toml").scene.joints[0].law.known_heads, plain.joints[0].law.known_heads);
    }
  }
  EXPECT_THAT(sample::errors(drained, {"joints.crack.drain_efficiency=0"}), testing::IsEmpty());
  const auto idle = sample::errors(crack("uplift = 'triangular'"), {"joints.crack.drain_efficiency=0"});
  ASSERT_THAT(idle, testing::SizeIs(1));
  EXPECT_THAT(idle[0], testing::HasSubstr("state that law, or leave drain_efficiency out"));
}

/// A cut with a drain of its own follows the law of [joint], which is set.
TEST(SceneUplift, ADrainThatFollowsALawThatIsSetHasNoEffect) {
  const std::string own = crack("drain_m = 1\ndrain_efficiency = 0.5");
  EXPECT_THAT(sample::errors(own, {}), testing::SizeIs(1));
  EXPECT_THAT(sample::errors(own, {"joints.crack.uplift=drained"}), testing::IsEmpty());
  EXPECT_THAT(sample::errors(own, {"joint.uplift=full"}), testing::IsEmpty());
}

TEST(SceneUplift, PiezometersNeedTheirLevelAndRisingStations) {
  expect_error(crack("uplift = 'heads'"), 30, {"without piezometers"});
  expect_error(crack("uplift = 'heads'\npiezometers_m = [[1, 2.8]]"), 31, {"by half", "piezometers_level_m"});
  expect_error(crack("uplift = 'heads'\npiezometers_m = [[2, 2.8], [1, 2.2]]\npiezometers_level_m = 3"), 31,
               {"a station of 1 m follows one of 2 m"});
  expect_error(crack("uplift = 'heads'\npiezometers_m = [[1, 2.8]]\npiezometers_level_m = 1.5"), 30,
               {"not above its downstream end at 2 m"});
}

TEST(SceneUplift, AJointThatDoesNotRunThroughCannotCrackByItself) {
  const std::string beside = sample::text + R"([[block]]
name = "beside"
material = "concrete"
vertices_m = [[3, 0], [5, 0], [5, 4], [3, 4]]
)";
  expect_error(sample::with("cohesion_pa = 1e5", "uplift = 'cracked'", beside), 30,
               {"joint \"crack\", which does not separate a part of the structure from the ground", "run through"});
}

/// A wall of 24 bricks had an error for each of 18 cross joints.
TEST(SceneUplift, JointsThatCannotCrackAreToldTogether) {
  const std::string wall = R"(
analysis = { duration_s = 1 }
joint = { friction_angle_deg = 30, uplift = "cracked" }
water = { upstream_level_m = 2 }
material.brick = { youngs_modulus_pa = 1e9, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[[block]]
name = "rock"
material = "brick"
fixed = true
vertices_m = [[-10, -2], [20, -2], [20, 0], [-10, 0]]
[[wall]]
name = "w"
material = "brick"
rows = 6
columns = 4
brick_length_m = 1
brick_height_m = 0.5
)";
  const std::vector<std::string> errors = sample::errors(wall, {});
  ASSERT_THAT(errors, testing::SizeIs(1));
  EXPECT_THAT(errors[0], testing::ContainsRegex("in joint \"w1-1 on w1-2\" and [0-9]+ more, which do not separate"));
}

}  // namespace
}  // namespace blockweir::scene_uplift_test
