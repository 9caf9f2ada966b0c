// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Pools that are shut in as the scene draws them.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene::scene_surface_test {
namespace {

using sample::errors;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A dam of 22 m on rock from -50 to 80 m, with a roof on posts or rock over its reservoir of 20 m.
std::string roofed(const std::string& roof_m, const std::string& keys = "upstream_wall_m = -50",
                   const std::string& level = "upstream_level_m = 20") {
  return R"(analysis = { duration_s = 1, rigid = "all" }
joint = { friction_angle_deg = 30 }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
fluid.model = "reservoir"
fluid.reservoir = { )" +
         keys + " }\nwater = { " + level + R"( }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-50, -10], [80, -10], [80, 0], [-50, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[0, 0], [16, 0], [16, 22], [0, 22]]
[[block]]
name = "roof"
material = "m"
fixed = true
vertices_m = )" +
         roof_m + "\n";
}

TEST(SceneSurface, APoolThatIsShutInIsRefused) {
  const auto found = errors(roofed("[[-50, 18], [0, 18], [0, 21], [-50, 21]]"));
  EXPECT_THAT(found, ElementsAre(AllOf(StartsWith("s.toml:5: error: the pool before upstream_wall_m has no surface: "
                                                  "block \"roof\" covers it at its level, 20 m; expected a free "
                                                  "surface on each pool; lower the level, shorten the block, or"),
                                       HasSubstr("leave upstream_wall_m out"))));
  EXPECT_THAT(errors(roofed("[[16, 8], [80, 8], [80, 21], [16, 21]]", "downstream_wall_m = 80",
                            "upstream_level_m = 20, downstream_level_m = 10")),
              ElementsAre(HasSubstr("the pool before downstream_wall_m has no surface: block \"roof\"")));
}

TEST(SceneSurface, APoolWithAnOpeningIsNot) {
  EXPECT_THAT(errors(roofed("[[-50, 18], [-1, 18], [-1, 21], [-50, 21]]")), IsEmpty());  // beside the dam
  EXPECT_THAT(errors(roofed("[[-49, 18], [0, 18], [0, 21], [-49, 21]]")), IsEmpty());    // at the wall
  EXPECT_THAT(errors(roofed("[[-50, 18], [0, 18], [0, 19], [-50, 19]]")), IsEmpty());    // under water
  EXPECT_THAT(errors(roofed("[[-50, 18], [0, 18], [0, 21], [-50, 21]]", "")), IsEmpty());
  EXPECT_THAT(errors(roofed("[[-50, 18], [0, 18], [0, 21], [-50, 21]]", "upstream_wall_m = -60")), IsEmpty());
  EXPECT_THAT(errors(roofed("[[-50, 0], [0, 0], [0, 21], [-50, 21]]")), IsEmpty());  // no pool
  EXPECT_THAT(
      errors(roofed("[[-50, 18], [0, 18], [0, 21], [-50, 21]]", "upstream_wall_m = -50", "upstream_level_m = 17.9")),
      IsEmpty());
}

}  // namespace
}  // namespace blockweir::scene::scene_surface_test
