// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Which keys two scenes have otherwise, as a user would set them.
#include "bridge/scene/read/differences.hpp"

#include <gtest/gtest.h>

namespace blockweir::scene::scene_differences_test {
namespace {

const std::string one = "analysis.duration_s = 3\n[[cut]]\nname = 'lift'\ncohesion_pa = 0\nfrom_m = [0, 1]\n";

TEST(SceneDifferences, AreKeysWithBothValues) {
  const std::string other = "[analysis]\nduration_s = 4 # longer\n[[cut]]\nname = 'lift'\ncohesion_pa = 1e5\n";
  EXPECT_EQ(differences_text(one, other, {"cut.lift.cohesion_pa=1e5"}),
            "analysis.duration_s is 3 there and 4 here, cut.lift.cohesion_pa is 0 there and 100000 here (--set), "
            "cut.lift.from_m is [0, 1] there and none here");
  EXPECT_EQ(differences_text(one, other + "[water]\ndensity_kg_per_m3 = 1000\n", {}),
            "analysis.duration_s is 3 there and 4 here, cut.lift.cohesion_pa is 0 there and 100000 here, "
            "cut.lift.from_m is [0, 1] there and none here, and 1 more key");
}

TEST(SceneDifferences, HaveNoDigitsThatSayNothing) {
  EXPECT_EQ(differences_text("f = 0.52000000000000002\nl = [0.1, 2.0]", "f = 0.5\nl = [0.30000000000000004, 2.0]", {}),
            "f is 0.52 there and 0.5 here, l is [0.1, 2] there and [0.30000000000000004, 2] here");
}

TEST(SceneDifferences, OfCommentsAloneOrOfWhatIsNoSceneAreTold) {
  EXPECT_EQ(differences_text(one, "# a comment\n" + one, {}), "its file differs in comments or layout alone");
  EXPECT_EQ(differences_text("not TOML", one, {}), "its scene.toml is not readable");
}

}  // namespace
}  // namespace blockweir::scene::scene_differences_test
