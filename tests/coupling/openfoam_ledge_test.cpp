// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// What lies between the mesh's lines and the blocks' edges: water at rest presses a dam that stands on a ledge, beside
// a slot, or under a thin film by its exact shape, and a wall that the mesh would let it through is refused.
#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_ledge_test {
namespace {

class Ledge : public OpenFoam {
 protected:
  static constexpr double weight = 9810;  // N/m3
  static constexpr double level_m = 10;

  static std::string block(const std::string& name, const std::string& vertices) {
    return "[[block]]\nname = \"" + name + "\"\nmaterial = \"stone\"\nfixed = true\nvertices_m = " + vertices + "\n";
  }
  static std::string box(double left, double bottom, double right, double top) {
    const auto corner = [](double x, double y) { return "[" + std::to_string(x) + ", " + std::to_string(y) + "]"; };
    return "[" + corner(left, bottom) + ", " + corner(right, bottom) + ", " + corner(right, top) + ", " +
           corner(left, top) + "]";
  }
  /// Cells of 0.5 m; a few steps. All is fixed: what it took for an open crack would follow the ground's length.
  [[nodiscard]] int run_with(const std::string& blocks) const {
    std::ofstream(folder / "scene.toml")
        << "[analysis]\nduration_s = 0.05\nrigid = \"all\"\n"
           "[material.stone]\nyoungs_modulus_pa = 5e10\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2500\n"
           "[joint]\nfriction_angle_deg = 30\n"
        << block("ground", "[[-15, -3], [35, -3], [35, 0], [-15, 0]]") << blocks
        << "[water]\nmay_overtop = true\nopen_crack_width_m = 0.05\nupstream_level_m = 10\n"
           "[fluid]\nmodel = \"openfoam\"\ncells_in_depth = 20\nupstream_depths = 0.5\ndownstream_depths = 0.5\n"
           "[output]\nframe_every_s = 0.01\n";
    return run("scene.toml", "o", "");
  }
  /// Of the last stored time's panels on the upright face at x [N/m].
  [[nodiscard]] double force_on_face(double x) const {
    std::istringstream lines(text("o/frames.jsonl"));
    std::string last;
    for (std::string line; std::getline(lines, line);) last = line;
    double sum = 0;
    const auto frame = nlohmann::json::parse(last);
    for (const auto& panel : frame["panels"]) {
      const auto at = [&](std::size_t i) { return panel[i].get<double>(); };
      if (std::abs(at(0) - x) + std::abs(at(2) - x) < 1e-9) sum += (at(4) + at(5)) / 2 * (at(1) - at(3));
    }
    return sum;
  }
};

TEST_F(Ledge, TheDamOnItIsPressedToItsFoot) {
  for (const double cells : {0.02, 0.2, 0.5, 0.9, 1.0, 1.1, 2.6}) {
    const double t = 0.5 * cells;
    ASSERT_EQ(run_with(block("ledge", box(-4, 0, 9, t)) + block("dam", box(0, t, 6, 11))), 0) << text("out");
    const Force all = water_force("o", {0, 0}, 100);
    std::printf("ledge of %.2f cells: %.1e\n", cells, all.force.x() / (weight * level_m * level_m / 2) - 1);
    EXPECT_NEAR(all.force.x() / (weight * level_m * level_m / 2), 1, 1e-5) << cells;
    EXPECT_NEAR(all.force.y() / (-weight * 4 * (level_m - t)), 1, 1e-5) << cells;
    EXPECT_NEAR(force_on_face(0) / (weight * std::pow(level_m - t, 2) / 2), 1, 1e-5) << cells;
  }
}

TEST_F(Ledge, AFilmOfWaterOnABermPressesIt) {
  for (const double y : {9.4, 9.7, 9.9}) {
    const std::string at = std::to_string(y);
    ASSERT_EQ(run_with(block("dam", "[[0, 0], [6, 0], [6, 11], [2, 11], [2, " + at + "], [0, " + at + "]]")), 0)
        << text("out");
    const Force dam = water_force("o", {3, 5}, 100);
    EXPECT_NEAR(dam.force.x() / (weight * level_m * level_m / 2), 1, 1e-5) << y;
    EXPECT_NEAR(dam.force.y() / (-weight * 2 * (level_m - y)), 1, 1e-4) << y;
  }
}

TEST_F(Ledge, ASlotBehindAToeBlockPressesTheDamToItsFoot) {
  for (const double gap : {0.06, 0.3, 0.5, 1.2}) {
    ASSERT_EQ(run_with(block("toe", box(-2 - gap, 0, -gap, 4.1)) + block("dam", box(0, 0, 6, 11))), 0) << text("out");
    const double force = weight * level_m * level_m / 2;
    EXPECT_NEAR(force_on_face(0) / force, 1, 1e-5) << gap;
    EXPECT_NEAR(water_force("o", {0, 0}, 100).force.x() / force, 1, 1e-5) << gap;
  }
}

TEST_F(Ledge, AWallThatTheMeshLetsWaterThroughIsRefusedWithTheMeshThatItTakes) {
  EXPECT_EQ(run_with(block("wall", box(0.1, 0, 0.7, 11))), 1);
  EXPECT_THAT(text("out"), testing::HasSubstr("do not resolve block \"wall\""));
  EXPECT_THAT(text("out"), testing::HasSubstr("raise cells_in_depth in [fluid] to"));
}

}  // namespace
}  // namespace blockweir::test::openfoam_ledge_test
