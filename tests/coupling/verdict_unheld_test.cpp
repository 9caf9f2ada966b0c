// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What no forces can hold is not said to stand, however slowly it begins to move.
#include "tests/coupling/verdicts.hpp"

namespace blockweir::test::verdict_unheld_test {
namespace {

using testing::HasSubstr;

/// 40 rows of 4 bricks that a sideways acceleration turns over. A linear program of their equilibrium (forces at both
/// ends of each face, Coulomb's law) bears 0.182622 g; the load comes slowly to some share of it, and stays.
TEST_F(Verdicts, AWallThatNoForcesHoldDoesNotStand) {
  constexpr double limit = 0.182622 * 9.81;
  for (const double share : {0.99, 1.01, 1.02}) {
    const auto summary = run(fmt::format(R"([analysis]
duration_s = 3
rigid = "all"
[joint]
friction_angle_deg = 30
[material.b]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 2000
[[block]]
name = "rock"
material = "b"
fixed = true
vertices_m = [[-20, -2], [80, -2], [80, 0], [-20, 0]]
[[wall]]
name = "w"
material = "b"
brick_length_m = 1
brick_height_m = 0.5
rows = 40
columns = 4
[[body_load]]
acceleration_x_m_per_s2 = {{ from = {}, to = {}, rate_per_s = 0.054 }}
)",
                                         0.96 * limit, share * limit));
    if (share < 1) {
      EXPECT_EQ(summary["outcome"], "stands") << text("out");
    } else if (summary["outcome"] != "fails") {
      ASSERT_EQ(summary["outcome"], "moving") << text("out");
      EXPECT_THAT(summary["moving"]["text"].get<std::string>(), HasSubstr("no forces within the joints' laws hold"));
    }
  }
}

}  // namespace
}  // namespace blockweir::test::verdict_unheld_test
