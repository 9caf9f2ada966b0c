// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What no forces can hold moves off, however little they lack.
#include "tests/coupling/verdicts.hpp"

namespace blockweir::test::verdict_unheld_test {
namespace {

using testing::HasSubstr;

/// 40 rows of 4 bricks that a sideways acceleration turns over. A linear program of their equilibrium (forces at both
/// ends of each face, Coulomb's law) bears 0.182622 g; the load comes slowly to some share of it, and stays.
std::string wall(double share, double step_s) {
  constexpr double limit = 0.182622 * 9.81;
  return fmt::format(R"([analysis]
duration_s = 3
step_s = {}
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
                     step_s, 0.96 * limit, share * limit);
}

TEST_F(Verdicts, AWallThatNoForcesHoldMovesOff) {
  EXPECT_EQ(run(wall(0.99, 0.01))["outcome"], "stands") << text("out");
  for (const double share : {1.01, 1.02}) EXPECT_EQ(run(wall(share, 0.02))["outcome"], "fails") << text("out");
}

/// Before many blocks fall, what sweeps leave of their laws is more than such a motion.
TEST_F(Verdicts, AWallMovesOffAlikeWithAnyStep) {
  const auto moved_m = [&](double step_s) -> double { return run(wall(1.02, step_s))["largest_displacement_m"]; };
  const double moved = moved_m(0.01);
  EXPECT_GT(moved, 0.05);
  EXPECT_NEAR(moved_m(0.02), moved, 0.15 * moved);
}

}  // namespace
}  // namespace blockweir::test::verdict_unheld_test
