// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// The bonded length in the table of joints is the L of the sliding factor (c L + N tan(phi))/T.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::test::bonded_length_test {
namespace {

nlohmann::json base_of(const std::string& bond, const std::string& mesh) {
  const std::string text = fmt::format(R"(analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 30 {} }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
water = {{ upstream_level_m = 4.5 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -3], [12, -3], [12, 0], [-10, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [2.5, 0], [1, 5], [0, 5]]
{})",
                                       bond, mesh);
  return process::safety_answer(scene::read_text(text, "wall.toml").scene, hydrostatic::make)["joints"][0];
}

double length_by_hand(const nlohmann::json& row, double cohesion_pa) {
  const double friction = std::tan(30 * std::numbers::pi / 180) * row["normal_n_per_m"].get<double>();
  return (row["sliding_factor"].get<double>() * row["shear_n_per_m"].get<double>() - friction) / cohesion_pa;
}

TEST(BondedLength, IsThatOfTheSlidingFactor) {
  const auto whole = base_of(", cohesion_pa = 5e4, tension_strength_pa = 5e4", "");
  EXPECT_NEAR(whole["bonded_length_m"].get<double>(), 2.5, 1e-6);
  EXPECT_NEAR(length_by_hand(whole, 5e4), 2.5, 1e-4);
  const auto cracked = base_of(", cohesion_pa = 5e4", "mesh_size_m = 0.5");
  EXPECT_LT(cracked["bonded_length_m"].get<double>(), 2.3);
  EXPECT_NEAR(length_by_hand(cracked, 5e4), cracked["bonded_length_m"].get<double>(), 1e-3);
  EXPECT_TRUE(base_of("", "")["bonded_length_m"].is_null());
}

/// It has no place in the joint, and the water no part that it would fill. Piezometers state a crack of known depth.
TEST(BondedLength, IsNoCrackForTheWater) {
  const auto uplift = [](const std::string& keys) { return base_of(keys, "")["uplift_n_per_m"].get<double>(); };
  const std::string bond = ", cohesion_pa = 5e4, bonded_length_m = 1";
  for (const std::string law : {", uplift = 'cracked'", ", uplift = 'triangular'"}) {
    EXPECT_NEAR(uplift(law + bond), uplift(law + ", cohesion_pa = 5e4"), 1) << law;
  }
  EXPECT_NEAR(uplift(bond + ", uplift = 'heads', piezometers_m = [[1.5, 4.5]], piezometers_level_m = 4.5"),
              9810 * 4.5 * (1.5 + 1.0 / 2), 1);
}

/// A wall whose face leaves the joint at a narrow angle, towards a thin toe or as a chamfer, at either end, or over
/// rock that falls away: what does not touch has no bond.
TEST(BondedLength, IsThatOfFacesThatTouch) {
  const int scenes = test::campaign(60);
  for (int seed = 1; seed <= scenes; ++seed) {
    test::Random any(static_cast<unsigned>(seed));
    const double size = any.over_decades(0.1, 100);
    const double length = size * any.between(0.3, 1);
    const double off = size * any.between(0.05, 0.5);  // along what does not touch
    const double rise = off * std::tan(any.over_decades(1e-4, 0.2));
    const double mirror = any.integer(0, 1) == 0 ? 1 : -1;
    const bool rock_falls_away = any.integer(0, 2) == 0;
    auto scene = solid::empty_scene();
    scene.default_joint.cohesion_pa = 1e4;
    const auto add = [&](std::vector<solid::Point> outline, bool fixed) {
      for (std::size_t i = 0; i < outline.size(); ++i) outline[i].x() *= mirror;
      if (mirror < 0) std::reverse(outline.begin(), outline.end());
      solid::add(scene, std::move(outline), fixed);
    };
    if (rock_falls_away) {
      add({{-size, -size}, {3 * size, -size}, {length + off, -rise}, {length, 0}, {-size, 0}}, true);
      add({{0, 0}, {length + off, 0}, {length / 2, size}, {0, size}}, false);
    } else {
      add({{-size, -size}, {3 * size, -size}, {3 * size, 0}, {-size, 0}}, true);
      add({{0, 0}, {length, 0}, {length + off, rise}, {length / 2, size}, {0, size}}, false);
    }
    const solid::Solid drawn(scene);
    double bonded = 0;
    for (const auto& c : drawn.contacts()) bonded += c.bond * c.bond_length;
    EXPECT_NEAR(bonded / length, 1, 1e-6) << "seed " << seed << ", rise " << rise / off;
  }
}

/// The last 3 m of a base are a chamfer of a degree: the joint is as long as what touches, and as level.
TEST(BondedLength, JointsHaveNoPartThatDoesNotTouch) {
  const std::string text = R"(analysis = { duration_s = 1, rigid = "all" }
water = { upstream_level_m = 2 }
joint = { friction_angle_deg = 20, cohesion_pa = 2000 }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -5], [20, -5], [20, 0], [-10, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [7, 0], [10, 0.052365], [4, 2], [3, 4], [0, 4]]
)";
  const auto row = process::safety_answer(scene::read_text(text, "chamfer.toml").scene, hydrostatic::make)["joints"][0];
  const double weight_n = 413.559e3;
  const double push_n = 9810 * 2 * 2 / 2.0;
  const double strength_n = 2000 * 7 + weight_n * std::tan(20 * std::numbers::pi / 180);
  EXPECT_NEAR(row["sliding_factor"].get<double>(), strength_n / push_n, 1e-4);
  EXPECT_NEAR(row["length_m"].get<double>(), 7, 1e-9);
}

}  // namespace
}  // namespace blockweir::test::bonded_length_test
