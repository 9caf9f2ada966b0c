// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// From a crack's water to the water in the mesh: a level slot that is opened step by step, from none to 3.5 cells, open
// to the pool and closed at its end. Under the law "full" its floor must feel still water's pressure at every width,
// and its roof less and less than that of the floor, until it is that of the water at the roof. With "flow" both must
// feel still water at their own height at every width, before, while and after the mesh takes over.
#include <algorithm>

#include "tests/openfoam.hpp"

namespace blockweir::test::openfoam_crack_test {
namespace {

class Slot : public OpenFoam {
 protected:
  static constexpr double weight = 9810;  // N/m3
  static constexpr double cell_m = 0.25;
  static constexpr double level_m = 8;
  static constexpr double floor_m = 3;
  static constexpr double length_m = 4;
  /// The slot's roof rises within half a second from each width to the next, and rests for another half: it has the
  /// widths, in cells, at 2, 3, 4, ... s.
  void write_scene(const std::string& law, const std::vector<double>& widths) const {
    std::string lift = "{ table = [[0, 0]";
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string width = ", " + std::to_string(widths[i] * cell_m) + "]";
      lift += ", [" + std::to_string(static_cast<double>(i) + 1.5) + width + ", [" + std::to_string(i + 2) + width;
    }
    lift += "] }";
    std::ofstream scene(folder / "scene.toml");
    const auto block = [&](const char* name, bool fixed, const char* vertices) {
      scene << "[[block]]\nname = \"" << name << "\"\nmaterial = \"stone\"\nfixed = " << (fixed ? "true" : "false")
            << "\nvertices_m = " << vertices << "\n";
    };
    scene << "[analysis]\nduration_s = " << widths.size() + 1.05
          << "\nrigid = \"all\"\nstart = \"unstressed\"\nmax_displacement_ratio = 1\n"
             "[material.stone]\nyoungs_modulus_pa = 5e10\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2500\n";
    block("ground", true, "[[-12, -1], [24, -1], [24, 0], [-12, 0]]");
    block("lower", true, "[[0, 0], [4, 0], [4, 3], [0, 3]]");
    block("upper", false, "[[0, 3], [4, 3], [4, 10], [0, 10]]");
    block("back", true, "[[4, 0], [14, 0], [14, 11], [4, 11]]");
    scene << "[[support]]\nblock = \"upper\"\npoint_m = [0, 3]\ndisplacement_x_m = 0\ndisplacement_y_m = " << lift
          << "\n[[support]]\nblock = \"upper\"\npoint_m = [0, 10]\ndisplacement_x_m = 0\n"
             "[[joints]]\nname = \"crack\"\nbetween = [\"lower\", \"upper\"]\nuplift = \""
          << law
          << "\"\n"
             "[water]\nupstream_level_m = 8\n"
             "[fluid]\nmodel = \"openfoam\"\ncells_in_depth = 32\nupstream_depths = 1\ndownstream_depths = 0.5\n"
             "[output]\nframe_every_s = 1\n";
  }
  [[nodiscard]] std::vector<nlohmann::json> frames() const {
    std::vector<nlohmann::json> frames;
    std::istringstream lines(text("o/frames.jsonl"));
    for (std::string line; std::getline(lines, line);) frames.push_back(nlohmann::json::parse(line));
    return frames;
  }
  /// Mean pressure on the level face at y, over the slot's length [Pa].
  static double mean_pressure(const nlohmann::json& frame, double y) {
    double sum = 0;
    for (const auto& panel : frame["panels"]) {
      const auto at = [&](std::size_t i) { return panel[i].get<double>(); };
      const bool on_face = std::abs(at(1) - y) < 1e-6 && std::abs(at(3) - y) < 1e-6;
      if (on_face) sum += std::abs(at(2) - at(0)) * (at(4) + at(5)) / 2;
    }
    return sum / length_m;
  }
  /// Over still water at the floor: pressures on floor and roof, and that of still water at the roof.
  struct Pressed {
    double cells = 0;
    double floor = 0;
    double roof = 0;
    double still = 0;
  };
  /// At each width, once it rests.
  [[nodiscard]] std::vector<Pressed> lifted(const std::string& law, const std::vector<double>& widths) const {
    write_scene(law, widths);
    EXPECT_EQ(run("scene.toml", "o", ""), 0) << text("out");
    const std::vector<nlohmann::json> frames = this->frames();
    if (frames.size() <= widths.size() + 1) return {};
    const double at_floor = weight * (level_m - floor_m);
    std::vector<Pressed> all;
    std::printf("cells  floor    roof     still water at the roof, all over still water at the floor\n");
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const double roof_m = floor_m + widths[i] * cell_m;
      all.push_back({widths[i], mean_pressure(frames[i + 2], floor_m) / at_floor,
                     mean_pressure(frames[i + 2], roof_m) / at_floor, (level_m - roof_m) / (level_m - floor_m)});
      std::printf("%5.2f  %.5f  %.5f  %.5f\n", all[i].cells, all[i].floor, all[i].roof, all[i].still);
    }
    return all;
  }
};

TEST_F(Slot, ItsLawHandsOverToTheWater) {
  const std::vector<Pressed> all = lifted("full", {1.5, 2, 2.25, 2.5, 2.75, 3, 3.5});
  ASSERT_EQ(all.size(), 7U);
  double before = 2;
  for (const Pressed& p : all) {
    EXPECT_NEAR(p.floor, 1, 1e-2) << p.cells;
    // The law's pressure up to two cells, the water's from three: in between a blend without a kink.
    const double x = std::clamp(p.cells - 2, 0.0, 1.0);
    const double open = x * x * (3 - 2 * x);
    EXPECT_NEAR(p.roof, 1 - open + open * p.still, 1e-2) << p.cells;
    EXPECT_LT(p.roof, before + 1e-3) << p.cells;
    before = p.roof;
  }
}

/// The tolerance is that of the sampled water: interFoam's pressures still swing a little after each lift, by less than
/// a hundredth of the slot's. What the joint's water has is exact, so that a jump where one gives way to the other
/// would show at once: half of the gap's weight, left out, is 7.5 % at three cells.
TEST_F(Slot, ItsFlowHandsOverToTheWaterWithoutAJump) {
  const std::vector<Pressed> all = lifted("flow", {1.9, 2.5, 3.1});
  ASSERT_EQ(all.size(), 3U);
  for (const Pressed& p : all) {
    EXPECT_NEAR(p.floor, 1, 1e-2) << p.cells;
    EXPECT_NEAR(p.roof, p.still, 1e-2) << p.cells;
  }
}

}  // namespace
}  // namespace blockweir::test::openfoam_crack_test
