// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// A dam of which courses and cross joints meet in points: corners that bear there hold it above the level of limit
// analysis, and the run says so.
#include "tests/processes.hpp"

namespace blockweir::test::pressing_corners_test {
namespace {

using testing::HasSubstr;

class PressingCorners : public Processes {
 protected:
  [[nodiscard]] std::string warnings(const std::string& level_m) const {
    std::ofstream(folder / "s.toml") << R"(
analysis = { duration_s = 0.1, rigid = "all", max_displacement_ratio = 0.05 }
joint = { friction_angle_deg = 33 }
water = { upstream_level_m = )" + level_m + R"( }
material.masonry = { youngs_modulus_pa = 8e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
[section]
material = "masonry"
outline_m = [[0, 0], [5.2, 0], [1.4, 8], [1.4, 9], [0, 9]]
[[joint_set]]
name = "courses"
dip_deg = 6
spacing_m = 0.75
offset_m = 0.3
friction_angle_deg = 28
[[joint_set]]
name = "cross joints"
dip_deg = 90
spacing_m = 0.7
offset_m = 0.35
[[block]]
name = "rock"
material = "masonry"
fixed = true
vertices_m = [[-15, -3], [25, -3], [25, 0], [-15, 0]]
)";
    fs::remove_all(folder / "r");
    EXPECT_EQ(shell(programs + "/blockweir run s.toml --inproc --out r --quiet"), 0) << text("out");
    return nlohmann::json::parse(text("r/summary.json"))["warnings"].dump();
  }
};

TEST_F(PressingCorners, AreToldOfWhereTheyHoldADamThatLimitAnalysisHasFail) {
  EXPECT_THAT(warnings("7.25"), HasSubstr("which only meet in a point, bear "));
  EXPECT_THAT(warnings("6"), testing::Not(HasSubstr("only meet in a point")));
}

}  // namespace
}  // namespace blockweir::test::pressing_corners_test
