// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// Blocks that lift off their joint, or drop from it, and levels that have nothing to do with a failure.
#include <fmt/format.h>

#include "tests/processes.hpp"

namespace blockweir::test::leaving_test {
namespace {

using testing::HasSubstr;

class Leaving : public Processes {
 protected:
  [[nodiscard]] nlohmann::json failure(const std::string& scene) const {
    std::ofstream(folder / "scene.toml") << scene;
    EXPECT_EQ(shell(programs + "/blockweir run scene.toml --inproc --out r"), 0) << text("out");
    return nlohmann::json::parse(text("r/summary.json"), nullptr, false)["failure"];
  }
};

/// A block of 1 x 1 m on level ground, or under a roof.
std::string one_block(bool under_a_roof, int density, const std::string& more) {
  return fmt::format(R"([analysis]
duration_s = 2
step_s = 0.005
stop_at_failure = true
[material.c]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = {}
[[block]]
name = "ground"
material = "c"
fixed = true
vertices_m = [[-20, {}], [20, {}], [20, {}], [-20, {}]]
[[block]]
name = "b"
material = "c"
vertices_m = [[0, 0], [1, 0], [1, 1], [0, 1]]
[[joints]]
name = "j"
between = ["ground", "b"]
friction_angle_deg = 30
{})",
                     density, under_a_roof ? 1 : -1, under_a_roof ? 1 : -1, under_a_roof ? 2 : 0, under_a_roof ? 2 : 0,
                     more);
}

TEST_F(Leaving, ABlockThatFloatsLiftsOffAtTheLevelOfItsWeight) {
  const auto found = failure(one_block(false, 800, R"(uplift = "full"
[water]
upstream_level_m = { table = [[0, 0.7], [2, 0.95]] }
downstream_level_m = { table = [[0, 0.7], [2, 0.95]] }
)"));
  EXPECT_EQ(found["mode"], "lifting");
  EXPECT_NEAR(found["level_m"].get<double>(), 0.8, 1e-3);
  EXPECT_THAT(text("out"), HasSubstr("fails by lifting off joint \"j\""));
}

TEST_F(Leaving, ABlockThatItsBondLetsGoDropsFromItsRoof) {
  const auto found = failure(one_block(true, 2400, R"(cohesion_pa = 1e5
tension_strength_pa = 40e3
[[point_load]]
block = "b"
point_m = [0.5, 0]
force_y_n_per_m = { table = [[0, 0], [1, -40e3]] }
)"));
  EXPECT_EQ(found["mode"], "falling");
  EXPECT_THAT(text("out"), HasSubstr("fails by falling off joint \"j\""));
}

TEST_F(Leaving, ALevelBelowAllThatMovesIsNotThatOfAFailure) {
  const auto found = failure(one_block(false, 2400, R"([water]
upstream_level_m = -0.5
[[point_load]]
block = "b"
point_m = [0, 0.3]
force_n_per_m = [20e3, 0]
)"));
  EXPECT_EQ(found["mode"], "sliding");
  EXPECT_TRUE(found["level_m"].is_null());
  EXPECT_THAT(text("out"), testing::Not(HasSubstr("level of failure")));
}

}  // namespace
}  // namespace blockweir::test::leaving_test
