// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// Uplift in a line of joints is drawn and told as one.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bridge/picture/section_state.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::picture::uplift_diagram_test {
namespace {

using nlohmann::json;

/// A base of six joints, with pressures that fall to zero at the toe.
json state_of_a_base_in_parts() {
  std::string text = R"(analysis = { duration_s = 1 }
joint = { friction_angle_deg = 30 }
water = { upstream_level_m = 5 }
material.stone = { youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[[block]]
name = "rock"
material = "stone"
fixed = true
vertices_m = [[-9, -5], [15, -5], [15, 0], [-9, 0]]
)";
  json base = {{"name", "water in joints"}, {"panels", json::array()}};
  for (int b = 0; b < 6; ++b) {
    text += fmt::format(
        "[[block]]\nname = \"s{0}\"\nmaterial = \"stone\"\nvertices_m = [[{0}, 0], [{1}, 0], [{1}, 6], [{0}, 6]]\n", b,
        b + 1);
    base["panels"].push_back({b, 0, b + 1, 0, 8000 * (6 - b), 8000 * (5 - b), b + 1});
  }
  return section_state(scene::read_text(text, "base.toml").scene, json::array({base}), 0, json::array());
}

TEST(UpliftDiagram, UpliftOfALineOfJointsIsDrawnToOneScale) {
  const json state = state_of_a_base_in_parts();
  int corners = 0;
  double deepest = 0;
  for (const json& one : state["acting"]) {
    if (one["kind"] != "uplift") continue;
    for (const json& p : one["diagrams"][0]) {
      if (p[1] < 0) ++corners;
      deepest = std::max(deepest, -p[1].get<double>());
    }
    const double x = one["diagrams"][0][2][0];  // its downstream end
    EXPECT_NEAR(one["diagrams"][0][2][1].get<double>(), one["diagrams"][0][3][1].get<double>() * (6 - x) / (7 - x),
                1e-9)
        << one["name"];
  }
  EXPECT_EQ(corners, 11);
  EXPECT_GT(deepest, 0.5);
}

TEST(UpliftDiagram, UpliftOfManyJointsHasOneRowOfTheLegend) {
  const json state = state_of_a_base_in_parts();
  std::vector<std::string> labels;
  for (const json& row : state["legend"]) labels.push_back(row["label"]);
  EXPECT_THAT(labels, testing::ElementsAre(testing::StartsWith("weight"), "uplift in 6 joints 144 kN/m"));
  EXPECT_FALSE(state["acting"].back()["labelled"].get<bool>());
}

}  // namespace
}  // namespace blockweir::picture::uplift_diagram_test
