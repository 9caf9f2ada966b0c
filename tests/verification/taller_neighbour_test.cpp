// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// A wall beside a taller structure that can move fails at its own level, though higher water would drown it and hold
// it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::test::taller_neighbour_test {
namespace {

std::string wall(Random& any, double height_m) {
  const double base_m = any.between(0.45, 0.6) * height_m;
  return fmt::format(R"(analysis = {{ duration_s = 1, rigid = "{3}" }}
joint = {{ friction_angle_deg = {0} }}
material.m = {{ youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-50, -10], [90, -10], [90, 0], [-50, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [{1}, 0], [{4}, {2}], [0, {2}]]
)",
                     any.between(20, 30), base_m, height_m, any.integer(0, 1) == 0 ? "all" : "none",
                     any.between(0.2, 0.5) * base_m);
}

std::string house(Random& any, double height_m) {
  const double left_m = any.between(0.8, 2) * height_m;
  return fmt::format(
      "[[block]]\nname = \"house\"\nmaterial = \"m\"\nvertices_m = [[{0}, 0], [{1}, 0], [{1}, {2}], [{0}, {2}]]\n",
      left_m, left_m + any.between(0.8, 2) * height_m, any.between(1.05, 2) * height_m);
}

std::string deck(double height_m) {
  const double low_m = 1.2 * height_m;
  return fmt::format(
      "[[block]]\nname = \"deck\"\nmaterial = \"m\"\nvertices_m = [[0, {0}], [{2}, {0}], [{2}, {1}], [0, {1}]]\n"
      "[[support]]\nblock = \"deck\"\npoint_m = [0, {0}]\ndisplacement_x_m = 0\ndisplacement_y_m = 0\n"
      "[[support]]\nblock = \"deck\"\npoint_m = [{2}, {0}]\ndisplacement_y_m = 0\n",
      low_m, 1.3 * height_m, 2 * height_m);
}

nlohmann::json level_of(const std::string& text) {
  return process::level_answer(scene::read_text(text, "wall").scene, hydrostatic::make);
}

TEST(TallerNeighbour, DoesNotHideTheLevelOfAWall) {
  Random any(1);
  int failed = 0;
  for (int n = 0; n < campaign(8); ++n) {
    const double height_m = any.between(3, 20);
    const std::string alone = wall(any, height_m);
    const nlohmann::json one = level_of(alone);
    const nlohmann::json both = level_of(alone + house(any, height_m));
    if (one["outcome"] != "fails" || one["level_m"] > 0.998 * height_m) continue;
    ++failed;
    ASSERT_EQ(both["outcome"], "fails") << n << alone;
    EXPECT_NEAR(both["level_m"].get<double>(), one["level_m"].get<double>(), 1e-5 * height_m) << n;
    ASSERT_EQ(both["limit_analysis"]["outcome"], "fails") << n;
    EXPECT_NEAR(both["limit_analysis"]["level_m"].get<double>(), one["limit_analysis"]["level_m"].get<double>(),
                1e-9 * height_m)
        << n;
  }
  EXPECT_GT(failed, 3);
}

/// Water that overtops the wall is held by it, not by a deck that it passes under.
TEST(TallerNeighbour, ADeckOnItsOwnSupportsHoldsNoWater) {
  Random any(2);
  for (int n = 0; n < campaign(4); ++n) {
    const double height_m = any.between(3, 20);
    const std::string overtopped =
        fmt::format("water = {{ upstream_level_m = {}, may_overtop = true }}\n", any.between(1.01, 1.15) * height_m);
    const std::string alone = overtopped + wall(any, height_m);
    const auto factor_of = [](const std::string& text) {
      return process::safety_answer(scene::read_text(text, "wall").scene, hydrostatic::make)["water_factor"]["factor"]
          .get<double>();
    };
    const double factor = factor_of(alone);
    EXPECT_NEAR(factor_of(alone + deck(height_m)), factor, 1e-9 * factor) << n;
    const nlohmann::json one = level_of(alone);
    const nlohmann::json both = level_of(alone + deck(height_m));
    ASSERT_EQ(both["outcome"], one["outcome"]) << n;
    if (one["outcome"] != "fails") continue;
    EXPECT_NEAR(both["level_m"].get<double>(), one["level_m"].get<double>(), 1e-6 * height_m) << n;
    EXPECT_NEAR(both["limit_analysis"]["level_m"].get<double>(), one["limit_analysis"]["level_m"].get<double>(),
                1e-9 * height_m)
        << n;
  }
}

}  // namespace
}  // namespace blockweir::test::taller_neighbour_test
