// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose verdict is looked at: what they say of a structure, and a dam whose level of sliding is known.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "tests/processes.hpp"

namespace blockweir::test {

inline constexpr double weight_of_water = 9810;  // N/m3

class Verdicts : public Processes {
 protected:
  /// Runs the scene in one process; its summary.
  [[nodiscard]] nlohmann::json run(const std::string& scene, const std::string& options = "") const {
    std::ofstream(folder / "scene.toml") << scene;
    fs::remove_all(folder / "r");
    EXPECT_EQ(shell(programs + "/blockweir run scene.toml --inproc --out r " + options), 0) << text("out");
    return nlohmann::json::parse(text("r/summary.json"), nullptr, false);
  }
};

/// A dam (0,0) (0.6,0) (0.15,1) (0,1) times its height on a level base, triangular uplift, density 2400.
struct Monolith {
  double height_m = 20;
  double youngs_modulus_pa = 30e9;
  double friction_angle_deg = 33;
  std::string analysis = "duration_s = 24\nstep_s = 0.01\nstop_at_failure = true";
  std::string level;

  /// Slides where H = (W - U) tan(phi): h^2/2 + tan(phi) B h/2 = W tan(phi)/(rho g).
  [[nodiscard]] double sliding_level() const {
    const double tangent = std::tan(friction_angle_deg * std::numbers::pi / 180);
    const double weight = 2400 * 9.81 * 0.375 * height_m * height_m;
    const double b = tangent * 0.6 * height_m / 2;
    return -b + std::sqrt(b * b + 2 * weight * tangent / weight_of_water);
  }
  [[nodiscard]] std::string scene() const {
    const double h = height_m;
    return fmt::format(R"([analysis]
{}
[material.c]
youngs_modulus_pa = {}
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[[block]]
name = "ground"
material = "c"
fixed = true
vertices_m = [[{}, {}], [{}, {}], [{}, 0], [{}, 0]]
[[block]]
name = "dam"
material = "c"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
[joint]
friction_angle_deg = {}
uplift = "triangular"
[[joints]]
name = "base"
between = ["ground", "dam"]
[water]
upstream_level_m = {}
may_overtop = true
[output]
frame_every_s = 100
history_every_s = 1
)",
                       analysis, youngs_modulus_pa, -2 * h, -0.3 * h, 2.6 * h, -0.3 * h, 2.6 * h, -2 * h, 0.6 * h,
                       0.15 * h, h, h, friction_angle_deg, level);
  }
};

}  // namespace blockweir::test
