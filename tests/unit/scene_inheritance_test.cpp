// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// What a joint does not state follows [joint], key by key, and who states a key himself.
#include "bridge/scene/read/own_laws.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_inheritance_test {
namespace {

using namespace blockweir::scene;
using sample::errors;

/// The sample with these laws of all joints and of its crack.
std::string laws(const std::string& of_all, const std::string& crack) {
  return sample::with("cohesion_pa = 1e5", crack,
                      sample::with("friction_angle_deg = 30", "friction_angle_deg = 30\n" + of_all));
}

Drain drain(const std::string& of_all, const std::string& crack) {
  return read_text(laws(of_all, crack), "s.toml").scene.joints.front().law.known_heads.drain.value_or(Drain{});
}

TEST(SceneInheritance, EachKeyOfADrainFollowsThatOfAllJoints) {
  const std::string all = "uplift = 'drained'\ndrain_m = 1\ndrain_efficiency = 0.5\ndrain_head_m = 2.1";
  EXPECT_EQ(drain(all, "drain_head_m = 2.2"), (Drain{1, 0.5, 2.2}));
  EXPECT_EQ(drain(all, "drain_m = 1.5"), (Drain{1.5, 0.5, 2.1}));
  EXPECT_EQ(drain(all, "drain_efficiency = 0.7"), (Drain{1, 0.7, 2.1}));
  EXPECT_EQ(drain(all, "uplift = 'drained'\ndrain_efficiency = 0.7"), (Drain{1, 0.7, 2.1}));
  EXPECT_EQ(drain(all, "uplift = 'drained'"), (Drain{1, 0.5, 2.1}));
}

TEST(SceneInheritance, AnotherLawBeginsWithoutADrain) {
  const std::string all = "uplift = 'drained'\ndrain_m = 1\ndrain_efficiency = 0.5";
  EXPECT_EQ(drain(all, "uplift = 'cracked'"), Drain{});
  EXPECT_THAT(errors(laws(all, "uplift = 'cracked'\ndrain_head_m = 2.1")),
              testing::ElementsAre(testing::HasSubstr("half of a drain")));
}

TEST(SceneInheritance, RowsAndLevelOfPiezometersFollowThoseOfAllJoints) {
  const std::string all = "uplift = 'heads'\npiezometers_m = [[1, 2.8], [2, 2.2]]\npiezometers_level_m = 3";
  const auto known = [&](const std::string& crack) {
    return read_text(laws(all, crack), "s.toml").scene.joints.front().law.known_heads;
  };
  const KnownHeads rows = known("piezometers_m = [[1.5, 2.5]]");
  EXPECT_EQ(rows.piezometers, (std::vector<Piezometer>{{1.5, 2.5}}));
  EXPECT_EQ(rows.level_m, 3);
  EXPECT_EQ(known("piezometers_level_m = 3.5").level_m, 3.5);
  EXPECT_EQ(known("piezometers_level_m = 3.5").piezometers.size(), 2U);
}

TEST(SceneInheritance, ThoseThatStateAKeyThemselvesAreKnown) {
  const std::string text = laws("uplift = 'drained'\ndrain_m = 1\ndrain_efficiency = 0.5", "drain_efficiency = 0.7");
  EXPECT_THAT(laws_that_state(text, "drain_efficiency"), testing::ElementsAre("joints.crack"));
  EXPECT_THAT(laws_that_state(text, "drain_m"), testing::IsEmpty());
}

}  // namespace
}  // namespace blockweir::scene_inheritance_test
