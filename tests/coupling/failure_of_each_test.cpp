// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Blocks that fail one after another: figures of a failure are of the block that they name.
#include <cmath>

#include "tests/processes.hpp"

namespace blockweir::test::failure_of_each_test {
namespace {

class FailureOfEach : public Processes {};

/// Two blocks on level ground, pushed by forces that grow: friction of 30 degrees holds each as long as its force is
/// below tan(30 deg) W.
TEST_F(FailureOfEach, IsDatedByTheBlockThatIsNamed) {
  constexpr double weight_n_per_m = 2500 * 9.81 * 0.5;
  constexpr double rate_n_per_m_s = 5000;
  const double slides_after_s = std::tan(M_PI / 6) * weight_n_per_m / rate_n_per_m_s;
  std::ofstream(folder / "s.toml") << R"(analysis = { duration_s = 4, step_s = 0.005, rigid = "all" }
expect = [
  { quantity = "failure_time_s", value = 0 },
  { quantity = "failure_time_s", of = "early", value = 0 },
  { quantity = "failure_time_s", of = "late", value = 0 },
  { quantity = "failure_time_s", of = "ground", value = 0 },
]
joint = { friction_angle_deg = 30 }
material.m = { youngs_modulus_pa = 50e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-2, -1], [60, -1], [60, 0], [-2, 0]]
[[block]]
name = "late"
material = "m"
vertices_m = [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]
[[block]]
name = "early"
material = "m"
vertices_m = [[20, 0], [21, 0], [21, 0.5], [20, 0.5]]
[[point_load]]
block = "late"
point_m = [0, 0.1]
force_x_n_per_m = { table = [[2, 0], [4, 10000]] }
[[point_load]]
block = "early"
point_m = [20, 0.1]
force_x_n_per_m = { table = [[0, 0], [4, 20000]] }
)";
  ASSERT_EQ(shell(programs + "/blockweir run s.toml --quiet --out o"), 0) << text("out");
  const nlohmann::json checks = nlohmann::json::parse(text("o/summary.json"))["checks"];
  EXPECT_NEAR(checks[0]["got"], slides_after_s, 0.011);
  EXPECT_EQ(checks[1]["got"], checks[0]["got"]);
  EXPECT_NEAR(checks[2]["got"], 2 + slides_after_s, 0.011);
  EXPECT_EQ(checks[3].value("why_none", ""), "no failure of ground");
}

}  // namespace
}  // namespace blockweir::test::failure_of_each_test
