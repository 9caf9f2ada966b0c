// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read fluid_hydrostatic solid_capacity
// Joints in tension whose uplift takes them to be closed are told of under every level, by the gravity method.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "bridge/process/sides.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/capacity/static_blocks.hpp"

namespace blockweir::test::opened_joints_test {
namespace {

struct Dam {
  double height_m;
  double crest_m;
  double base_m;  ///< the upstream face is upright
  double level_m;
  bool wet_joint;  ///< triangular uplift, or none

  /// Way of the resultant from the toe, over the base.
  [[nodiscard]] double resultant() const {
    constexpr double water = 9810;
    constexpr double stone = 2400 * 9.81;
    const double block = stone * crest_m * height_m;
    const double wedge = stone * (base_m - crest_m) * height_m / 2;
    const double uplift = wet_joint ? water * level_m * base_m / 2 : 0;
    const double push = water * level_m * level_m / 2;
    const double moment = block * (base_m - crest_m / 2) + wedge * (base_m - crest_m) * 2 / 3 -
                          uplift * base_m * 2 / 3 - push * level_m / 3;
    return moment / (block + wedge - uplift) / base_m;
  }
  [[nodiscard]] double factor() const {
    constexpr double water = 9810;
    const double weight = 2400 * 9.81 * (crest_m + base_m) / 2 * height_m;
    const double uplift = wet_joint ? water * level_m * base_m / 2 : 0;
    return (weight - uplift) * 2 / (water * level_m * level_m / 2);  // tan(phi) = 2
  }
  [[nodiscard]] std::string text() const {
    return fmt::format(R"(
analysis = {{ duration_s = 1, rigid = "all" }}
joint = {{ friction_angle_deg = 63.43494882292201, uplift = "{}" }}
material.stone = {{ youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
water = {{ upstream_level_m = {} }}
[[block]]
name = "rock"
material = "stone"
fixed = true
vertices_m = [[-60, -9], [90, -9], [90, 0], [-60, 0]]
[[block]]
name = "dam"
material = "stone"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
)",
                       wet_joint ? "triangular" : "none", level_m, base_m, crest_m, height_m, height_m);
  }
};

TEST(OpenedJoints, AreToldOfWhereTheResultantLeavesTheMiddleThird) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  int told = 0;
  int closed = 0;
  for (int n = 0; n < 400; ++n) {
    Dam dam{};
    dam.height_m = 5 + 35 * share(random);
    dam.crest_m = dam.height_m * (0.1 + 0.1 * share(random));
    dam.base_m = dam.height_m * (0.5 + 0.3 * share(random));
    dam.level_m = dam.height_m * (0.6 + 0.4 * share(random));
    dam.wet_joint = share(random) < 0.7;
    const double open = 1 - 3 * dam.resultant();
    if (dam.resultant() < 0.02 || dam.factor() < 1.02 || std::abs(open - 0.01) < 0.002) continue;
    const scene::Scene scene = scene::read_text(dam.text(), "dam").scene;
    solid::StillWater water(scene, hydrostatic::make);
    solid::SearchBudget effort("rest");
    solid::StaticBlocks blocks(scene, &water, effort);
    ASSERT_TRUE(blocks.begin(dam.level_m)) << dam.text();
    const std::vector<std::string> warnings = blocks.warnings(dam.level_m);
    if (open < 0.01) {
      ++closed;
      EXPECT_THAT(warnings, testing::IsEmpty()) << dam.text();
      continue;
    }
    ++told;
    ASSERT_EQ(warnings.size(), 1U) << dam.text();
    const std::string found = warnings[0].substr(warnings[0].find("over ") + 5);
    EXPECT_NEAR(std::stod(found) / 100, open, 2e-3) << warnings[0];
    EXPECT_THAT(warnings[0], testing::HasSubstr(fmt::format("at a level of {:.4g} m", dam.level_m)));
    EXPECT_THAT(warnings[0], testing::HasSubstr(dam.wet_joint ? "takes it to be closed" : "keeps water out of it"));
  }
  EXPECT_GT(told, 40);
  EXPECT_GT(closed, 20);
}

}  // namespace
}  // namespace blockweir::test::opened_joints_test
