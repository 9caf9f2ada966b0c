// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// A breach ends still water: what its pressures move from then on is not what failed.
#include "tests/coupling/verdicts.hpp"

namespace blockweir::test::verdict_breach_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A masonry dam of 30 m, whose lift joint at 12 m is weak, before a pond that rises.
std::string dam(const std::string& analysis) {
  return "analysis = { " + analysis + R"( }
material.m = { youngs_modulus_pa = 8e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
joint = { friction_angle_deg = 40, uplift = "drained", drain_m = 2, drain_efficiency = 0 }
water = { upstream_level_m = { from = 26, rate_per_s = 0.2, to = 30 }, downstream_level_m = 5 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-40, -10], [70, -10], [70, 0], [-40, 0]]
[section]
material = "m"
outline_m = [[0, 0], [22.5, 0], [4, 24.666666666666668], [4, 30], [0, 30]]
[[cut]]
name = "lift 6"
points_m = [[-1, 6], [30, 6]]
[[cut]]
name = "weak lift"
points_m = [[-1, 12], [30, 12]]
friction_angle_deg = 28
)";
}

TEST_F(Verdicts, WhatMovesOnlyAfterABreachIsKeptApart) {
  const auto summary = run(dam("duration_s = 20, rigid = \"all\""));
  ASSERT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_EQ(summary["failure"]["joint"], "weak lift");
  EXPECT_EQ(summary["failure"]["blocks"], nlohmann::json({"s3"}));
  EXPECT_EQ(summary["breach"]["blocks_after"], nlohmann::json({"s2", "s1"}));
  EXPECT_THAT(text("out"), HasSubstr("after the breach blocks \"s2\" and \"s1\" also move, by these pressures"));
  EXPECT_THAT(text("out"), Not(HasSubstr("after it")));
  EXPECT_THAT(text("out"), Not(HasSubstr("no open water reaches")));
  const auto before = run(dam("duration_s = 20, rigid = \"all\", stop_at_failure = true"));
  EXPECT_EQ(before["failure"]["level_m"], summary["failure"]["level_m"]);
  EXPECT_FALSE(before.contains("breach"));
  EXPECT_THAT(text("out"), Not(HasSubstr("BREACH")));
}

TEST_F(Verdicts, ARunMayEndAtABreach) {
  const auto whole = run(dam("duration_s = 20, rigid = \"all\""));
  EXPECT_THAT(text("out"), HasSubstr("where blocks come to rest is no answer (stop_at_breach ends it here)"));
  const auto summary = run(dam("duration_s = 20, rigid = \"all\", stop_at_breach = true"));
  EXPECT_EQ(summary["outcome"], "fails") << text("out");
  EXPECT_EQ(summary["breach"]["time_s"], whole["breach"]["time_s"]);
  EXPECT_THAT(text("out"), HasSubstr("from then on water would flow: the run ends here"));
  EXPECT_NEAR(summary["simulated_s"], whole["breach"]["time_s"], 0.05);
}

}  // namespace
}  // namespace blockweir::test::verdict_breach_test
