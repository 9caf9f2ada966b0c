// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Which blocks are crumbs, and that a scene with some is warned of.
#include "bridge/scene/crumbs.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene::crumbs_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Squares of these sides beside each other on rock, named a, b, ...
std::string row_of(const std::vector<double>& sides_m) {
  std::string text = R"(
analysis = { duration_s = 1 }
joint = { friction_angle_deg = 30 }
material.stone = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[[block]]
name = "rock"
material = "stone"
fixed = true
vertices_m = [[-9, -3], [50, -3], [50, 0], [-9, 0]]
)";
  double x = 0;
  char name = 'a';
  for (const double side_m : sides_m) {
    text += fmt::format(
        "[[block]]\nname = \"{0}\"\nmaterial = \"stone\"\nvertices_m = [[{1}, 0], [{2}, 0], [{2}, {3}], [{1}, {3}]]\n",
        name, x, x + side_m, side_m);
    x += side_m;
    ++name;
  }
  return text;
}

TEST(Crumbs, AreBelowATenThousandthOfTheMedianBlock) {
  EXPECT_THAT(crumbs(read_text(row_of({2, 1, 0.011}), "s.toml").scene.blocks), ElementsAre(false, false, false, false));
  EXPECT_THAT(crumbs(read_text(row_of({2, 1, 0.009}), "s.toml").scene.blocks), ElementsAre(false, false, false, true));
  EXPECT_THAT(crumbs(read_text(row_of({1, 0.011}), "s.toml").scene.blocks), ElementsAre(false, false, false));
  EXPECT_THAT(crumbs(read_text(row_of({1, 0.009}), "s.toml").scene.blocks), ElementsAre(false, false, true))
      << "of two the larger is the median";
  EXPECT_THAT(crumbs(read_text(row_of({0.009}), "s.toml").scene.blocks), ElementsAre(false, false));
}

TEST(Crumbs, AreWarnedOfByTheSmallest) {
  EXPECT_THAT(read_text(row_of({2, 1, 0.011}), "s.toml").scene.warnings, Not(Contains(HasSubstr("crumb"))));
  EXPECT_THAT(read_text(row_of({2, 1, 0.009}), "s.toml").scene.warnings,
              Contains(HasSubstr("block \"c\" of 8.1e-05 m2 is a crumb")));
  EXPECT_THAT(read_text(row_of({2, 1, 1, 0.009, 0.005}), "s.toml").scene.warnings,
              Contains(HasSubstr("2 blocks are crumbs, the smallest \"e\" of 2.5e-05 m2")));
}

}  // namespace
}  // namespace blockweir::scene::crumbs_test
