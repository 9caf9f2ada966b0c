// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// Surfaces that are straight but for rounded coordinates: the rock beyond a dam's toe, or the base itself. The bond of
// the base must not notice.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::flat_corners_test {
namespace {

constexpr double dip = 0.14;  // tangent
constexpr double base_m = 9;
constexpr double level_m = 9.5;
constexpr double cohesion_pa = 25e3;
constexpr double friction_deg = 24;
constexpr double density = 2250;
constexpr double gravity = 9.81;
constexpr double section_m2 = 62.45;

struct Slope {
  double kink_rad;  ///< at the toe
  double load_n_per_m;
  std::vector<double> surveyed_m{};  ///< points of the base, their heights rounded to 1 mm
};

/// Strength over force along the base.
double factor_by_hand(const Slope& slope) {
  const double weight = density * gravity * section_m2 + slope.load_n_per_m;
  const double water = 1000 * gravity * level_m * level_m / 2;
  const double a = std::atan(dip);
  const double normal = weight * std::cos(a) - water * std::sin(a);
  const double shear = weight * std::sin(a) + water * std::cos(a);
  const double length = base_m / std::cos(a);
  return (cohesion_pa * length + normal * std::tan(friction_deg * M_PI / 180)) / shear;
}

double factor_by_blocks(const Slope& slope, const std::string& law) {
  const double beyond = std::tan(-std::atan(dip) + slope.kink_rad);
  std::string up;
  std::string down;
  for (const double x : slope.surveyed_m) {
    const std::string point = fmt::format("[{:.17g}, {:.3f}], ", x, -dip * x);
    down += point;
    up.insert(0, point);
  }
  const std::string scene = fmt::format(R"(analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 45 }}
material.m = {{ youngs_modulus_pa = 8e9, poissons_ratio = 0.2, density_kg_per_m3 = {} }}
water = {{ upstream_level_m = {} }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-20, -10], [30, -10], [30, {:.17g}], [9, {:.17g}], {}[0, 0], [-20, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[0, 0], {}[9, {:.17g}], [2.5, 9.5], [2.5, 12], [0, 12]]
[[joints]]
name = "base"
between = ["rock", "dam"]
friction_angle_deg = {}
cohesion_pa = {}
{}
[[point_load]]
block = "dam"
point_m = [1.2, 11]
force_y_n_per_m = {:.17g}
)",
                                        density, level_m, -dip * base_m + 21 * beyond, -dip * base_m, up, down,
                                        -dip * base_m, friction_deg, cohesion_pa, law, -slope.load_n_per_m);
  const auto answer = process::safety_answer(scene::read_text(scene, "slope").scene, hydrostatic::make);
  return answer["factor"].is_number() ? answer["factor"].get<double>() : std::nan("");
}

class FlatCorners : public testing::TestWithParam<const char*> {};

TEST_P(FlatCorners, DoNotPullBondsOff) {
  std::mt19937 random(26);
  for (int i = 0; i < 30; ++i) {
    const double magnitude = std::pow(10, std::uniform_real_distribution(-8.0, -4.0)(random));
    const Slope slope{i % 2 == 0 ? magnitude : -magnitude, std::uniform_real_distribution(200e3, 800e3)(random)};
    const double expected = factor_by_hand(slope);
    EXPECT_NEAR(factor_by_blocks(slope, GetParam()), expected, 2e-3 * expected)
        << slope.kink_rad << ", " << slope.load_n_per_m;
  }
}

TEST_P(FlatCorners, OfASurveyedBaseDoNotEither) {
  std::mt19937 random(27);
  for (int i = 0; i < 20; ++i) {
    Slope slope{1e-5, std::uniform_real_distribution(200e3, 800e3)(random)};
    for (int k = 0; k <= i % 4; ++k) {
      slope.surveyed_m.push_back(2 * k + 0.5 + std::uniform_real_distribution(0.0, 1.0)(random));
    }
    const double expected = factor_by_hand(slope);
    EXPECT_NEAR(factor_by_blocks(slope, GetParam()), expected, 3e-3 * expected)
        << testing::PrintToString(slope.surveyed_m) << ", " << slope.load_n_per_m;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, FlatCorners, testing::Values("", "keeps_cohesion = true"));

}  // namespace
}  // namespace blockweir::test::flat_corners_test
