// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Columns whose bonds last, pushed by more than they bear: they turn over about their toe, the tension of the base
// holding them back by no more than its strength.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::solid::lasting_bonds_fall_test {
namespace {

constexpr double gravity_m_per_s2 = 9.81;
constexpr double beyond = 1.05;  // times what the column bears

struct Column {
  int blocks;
  double width_m;
  double height_m;  ///< of a block
  double density_kg_per_m3;
  double tension_pa;
  double step_s;

  [[nodiscard]] double total_m() const { return blocks * height_m; }
  [[nodiscard]] double mass_kg_per_m() const { return density_kg_per_m3 * width_m * total_m(); }
  /// Moment about the toe that weight and tension resist: of the whole base, as at the limit.
  [[nodiscard]] double resists() const {
    return mass_kg_per_m() * gravity_m_per_s2 * width_m / 2 + tension_pa * width_m * width_m / 2;
  }
  [[nodiscard]] double push_m_per_s2() const { return beyond * resists() / (mass_kg_per_m() * total_m() / 2); }
  /// Of the column's turning about its toe as it begins.
  [[nodiscard]] double turning_per_s2() const {
    const double inertia = mass_kg_per_m() * (width_m * width_m + total_m() * total_m()) / 3;
    return (beyond - 1) * resists() / inertia;
  }

  [[nodiscard]] scene::Scene scene() const {
    std::string text = fmt::format(R"(
analysis = {{ duration_s = 1, step_s = {}, rigid = "all" }}
joint = {{ friction_angle_deg = 45, cohesion_pa = {}, tension_strength_pa = {}, keeps_cohesion = true }}
material.m = {{ youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = {} }}
body_load = [{{ acceleration_x_m_per_s2 = {} }}]
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-50, -9], [50, -9], [50, 0], [-50, 0]]
)",
                                   step_s, tension_pa, tension_pa, density_kg_per_m3, push_m_per_s2());
    for (int k = 0; k < blocks; ++k) {
      text += fmt::format(R"([[block]]
name = "b{0}"
material = "m"
vertices_m = [[0, {1}], [{3}, {1}], [{3}, {2}], [0, {2}]]
)",
                          k, k * height_m, (k + 1) * height_m, width_m);
    }
    return scene::read_text(text, "column").scene;
  }
};

TEST(LastingBondsFall, AColumnTurnsOverAsFastAsItsExcessOfMomentHasIt) {
  test::Random any(77);
  for (int k = 0; k < test::campaign(40); ++k) {
    const Column column{.blocks = any.integer(2, 30),
                        .width_m = any.between(0.5, 2),
                        .height_m = any.between(0.4, 0.9),
                        .density_kg_per_m3 = any.between(1000, 2500),
                        .tension_pa = any.over_decades(1e2, 1e5),
                        .step_s = any.over_decades(1e-3, 1e-2)};
    if (column.total_m() < 2 * column.width_m) continue;
    const scene::Scene scene = column.scene();
    Solid solid(scene);
    solid.settle({});
    const long steps = std::lround(0.3 / column.step_s);
    for (long n = 0; n < steps; ++n) {
      solid.advance(static_cast<double>(n) * column.step_s, static_cast<double>(n + 1) * column.step_s, {});
    }
    const double time_s = static_cast<double>(steps) * column.step_s;
    const double expected_m = column.turning_per_s2() * time_s * time_s / 2 * column.total_m();
    EXPECT_GT(solid.largest_displacement_m(), 0.9 * expected_m) << k;
  }
}

}  // namespace
}  // namespace blockweir::solid::lasting_bonds_fall_test
