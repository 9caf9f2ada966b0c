// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Uplift laws that leave pressure out where a crack dips are warned of.
#include <fmt/format.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::dipping_uplift_test {
using namespace blockweir::scene;
using sample::warnings;
using sample::with;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

TEST(DippingUplift, FullUpliftOfACrackThatFallsIsAWarning) {
  const auto falling = [](const std::string& y) {
    std::string scene = with("[3, 2], [0, 2]]", "[3, " + y + "], [0, 2]]");
    scene.replace(scene.find("[[0, 2], [3, 2]"), 15, "[[0, 2], [3, " + y + "]");
    scene.replace(scene.find("cohesion_pa = 1e5"), 17, "uplift = \"full\"");
    return scene;
  };
  EXPECT_THAT(warnings(falling("1.95")), IsEmpty());
  const auto warned = HasSubstr("its lowest point lies 1 m lower, where water at rest presses by as much more");
  EXPECT_THAT(warnings(falling("1")), testing::Contains(warned));
}

TEST(DippingUplift, OtherCracksThatFallAreCounted) {
  const auto cuts = [](int count) {
    std::string scene =
        "[analysis]\nduration_s = 1\n[material.m]\nyoungs_modulus_pa = 1e9\npoissons_ratio = 0.2\n"
        "density_kg_per_m3 = 2400\n[water]\nupstream_level_m = 9\n"
        "[[block]]\nname = \"rock\"\nmaterial = \"m\"\nfixed = true\nvertices_m = [[-9, -1], [9, -1], [9, 0], [-9, "
        "0]]\n"
        "[section]\nmaterial = \"m\"\noutline_m = [[0, 0], [4, 0], [4, 9], [0, 9]]\n";
    for (int i = 0; i < count; ++i) {
      scene += fmt::format("[[cut]]\nname = \"c{0}\"\nuplift = \"full\"\npoints_m = [[0, {1}], [4, {2}]]\n", i,
                           3 + 2 * i, 1 + 2 * i);
    }
    return warnings(scene);
  };
  EXPECT_THAT(cuts(1), testing::Contains(HasSubstr("presses by as much more; expected")));
  EXPECT_THAT(cuts(2), testing::Contains(HasSubstr("presses by as much more, and 1 more crack; expected")));
  EXPECT_THAT(cuts(3), testing::Contains(HasSubstr("presses by as much more, and 2 more cracks; expected")));
}

/// A linear head has rho g times the dip more, whatever the level.
TEST(DippingUplift, LinearUpliftOfACrackThatBendsDownIsAWarningAndOfOneThatBendsUpNot) {
  const auto bent = [](const std::string& law, const std::string& y) {
    std::string scene = with("[3, 2], [0, 2]]", "[3, 2], [1.5, " + y + "], [0, 2]]");
    scene.replace(scene.find("[[0, 2], [3, 2]"), 15, "[[0, 2], [1.5, " + y + "], [3, 2]");
    scene.replace(scene.find("cohesion_pa = 1e5"), 17, "uplift = \"" + law + "\"");
    return warnings(scene);
  };
  for (const char* y : {"1.95", "2.5"}) EXPECT_THAT(bent("triangular", y), IsEmpty());
  for (const char* law : {"triangular", "cracked"}) {
    EXPECT_THAT(
        bent(law, "1"),
        testing::Contains(testing::AllOf(
            HasSubstr("s.toml:30: warning: joint \"crack\" dips: at (1.5, 1) m it lies 1 m lower"),
            HasSubstr("9.81 kPa of water pressure are left out there"), HasSubstr("state uplift = \"flow\" for it"))));
  }
}

}  // namespace
}  // namespace blockweir::dipping_uplift_test
