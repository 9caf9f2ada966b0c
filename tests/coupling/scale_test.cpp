// SPDX-License-Identifier: GPL-3.0-or-later
// links: nlohmann_json::nlohmann_json
// The same dam from 3 mm to 3 km, filled as Froude's model law says: head at sliding over height is that of limit
// equilibrium, and the same at all sizes, whether its stiffness is scaled or that of concrete.
#include <fmt/format.h>

#include <cmath>

#include "tests/processes.hpp"

namespace blockweir::test::scale_test {
namespace {

class Scale : public Processes {
 protected:
  static constexpr double friction_deg = 33;
  static constexpr double breadth = 0.6;  // of the height
  static constexpr double crest = 0.15;
  static constexpr double density = 2400;

  /// Head at which (W - U) tan(phi) = H, with triangular uplift: W - r g b h/2 = r g h^2/(2 tan(phi)), over the height.
  static double exact() {
    const double weight = density / 1000 * (breadth + crest) / 2;
    const double friction = std::tan(friction_deg * std::acos(-1) / 180);
    return friction * (-breadth / 2 + std::sqrt(breadth * breadth / 4 + 2 * weight / friction));
  }

  /// Head at failure over height of a dam `h` m high; time goes as sqrt(h).
  double head(double h, double modulus_pa) {
    const double t = std::sqrt(h / 20) * 34;
    std::ofstream(folder / "dam.toml") << fmt::format(
        R"([analysis]
duration_s = {0}
step_s = {1}
stop_at_failure = true
[material.c]
youngs_modulus_pa = {2}
poissons_ratio = 0.2
density_kg_per_m3 = {3}
[[block]]
name = "ground"
material = "c"
fixed = true
vertices_m = [[{4}, {5}], [{6}, {5}], [{6}, 0], [{4}, 0]]
[[block]]
name = "dam"
material = "c"
vertices_m = [[0, 0], [{7}, 0], [{8}, {9}], [0, {9}]]
[joint]
friction_angle_deg = {10}
uplift = "triangular"
[[joints]]
name = "base"
between = ["ground", "dam"]
[water]
upstream_level_m = {{ table = [[0, {11}], [{12}, {13}], [{0}, {14}]] }}
may_overtop = true
[output]
frame_every_s = {0}
history_every_s = {0}
)",
        t, t / 3400, modulus_pa, density, -2 * h, -0.3 * h, 2.6 * h, breadth * h, crest * h, h, friction_deg,
        0.5 * exact() * h, t / 6, 0.985 * exact() * h, 1.015 * exact() * h);
    EXPECT_EQ(shell(programs + "/blockweir run dam.toml --inproc --quiet --out o"), 0) << h << ": " << text("out");
    const auto summary = nlohmann::json::parse(text("o/summary.json"));
    EXPECT_EQ(summary["outcome"], "fails") << h << ": " << text("out");
    const double found = summary["outcome"] == "fails" ? summary["failure"]["level_m"].get<double>() / h : 0;
    fs::remove_all(folder / "o");
    return found;
  }
};

constexpr double sizes_m[] = {0.003, 0.03, 0.3, 3.0, 30.0, 300.0, 3000.0};

TEST_F(Scale, AModelWhoseStiffnessIsScaledFailsAsItsDam) {
  for (const double h : sizes_m) EXPECT_NEAR(head(h, 1.5e9 * h) / exact(), 1, 1e-4) << h;
}

TEST_F(Scale, AModelOfConcreteFailsAsItsDam) {
  for (const double h : sizes_m) {
    if (h <= 30) EXPECT_NEAR(head(h, 30e9) / exact(), 1, 1e-4) << h;
  }
}

}  // namespace
}  // namespace blockweir::test::scale_test
