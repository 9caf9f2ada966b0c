// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_answers bridge_scene_read
// Corners that bear by being sharp: feather edges that lie flush with the ground, and corners in a kink of the ground.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/read/read.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answers/crushed_corners.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "solid/capacity/static_strength.hpp"
#include "tests/independent/random_structures.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::test::sharp_corners_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

constexpr const char* stone =
    "material.m = { youngs_modulus_pa = 30e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }\n";

/// A wedge on a plane that rises downstream by `rise_deg` to the level, or falling, rock beyond it; a force pushes it
/// up with `share` of what friction and weight hold.
std::string pushed_wedge(double size_m, double rise_deg, double beyond_deg, double friction_deg, double share,
                         bool rigid) {
  const double height = size_m;
  const double length = height / std::tan(rise_deg * degree);
  const double end = length + size_m;
  const double weight = 2500 * 9.81 * height * length / 2;
  return fmt::format(R"(analysis = {{ duration_s = 1, rigid = "{}" }}
joint = {{ friction_angle_deg = {} }}
{}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[{}, {}], [{}, {}], [{}, {}], [{}, 0], [0, {}], [0, {}], [{}, {}]]
[[block]]
name = "wedge"
material = "m"
vertices_m = [[0, {}], [{}, 0], [0, 0]]
[[point_load]]
block = "wedge"
point_m = [0, {}]
force_n_per_m = [{}, 0]
)",
                     rigid ? "all" : "named", friction_deg, stone, -size_m, -5 * size_m, end, -5 * size_m, end,
                     -size_m * std::tan(beyond_deg * degree), length, -height, -2 * height, -size_m, -2 * height,
                     -height, length, -0.8 * height, share * weight * std::tan((rise_deg + friction_deg) * degree));
}

TEST(SharpCorners, AFeatherEdgeSlidesOutOverTheGroundsCorner) {
  for (int seed = 1; seed <= campaign(20); ++seed) {
    independent::Random random(static_cast<std::uint64_t>(seed), "feather edges");
    const double size_m = random.between_orders(0.1, 10);
    const double rise = random.between(1, 8);
    const double beyond = random.between(0, 3);
    const double friction = random.between(5, 30);
    const bool rigid = random.chance(0.5);
    for (const double share : {0.99, 1.01}) {
      const std::string text = pushed_wedge(size_m, rise, beyond, friction, share, rigid);
      SCOPED_TRACE(fmt::format("seed {}\n{}", seed, text));
      const scene::Scene scene = scene::read_text(text, "feather").scene;
      solid::SearchBudget effort("feather");
      EXPECT_EQ(solid::StaticBlocks(scene, nullptr, effort).begin(0), share < 1);
    }
  }
}

/// Two wedges on planes of slopes `steep` and `flat` that meet in a kink, an upright face without friction between
/// them.
struct TwoWedges {
  double steep_deg;
  double flat_deg;
  double width_up_m;
  double width_low_m;
  double height_m;  ///< of the face between them
  double friction_deg;

  [[nodiscard]] double rise_m() const { return width_up_m * std::tan(steep_deg * degree); }
  [[nodiscard]] double fall_m() const { return width_low_m * std::tan(flat_deg * degree); }
  [[nodiscard]] std::string text() const {
    return fmt::format(R"(analysis = {{ duration_s = 1, kind = "static" }}
joint = {{ friction_angle_deg = {} }}
{}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[{}, -50], [{}, -50], [{}, {}], [0, 0], [{}, {}], [{}, {}]]
[[block]]
name = "low"
material = "m"
vertices_m = [[0, 0], [{}, {}], [{}, {}], [0, {}]]
[[block]]
name = "up"
material = "m"
vertices_m = [[0, 0], [0, {}], [{}, {}], [{}, {}]]
[[joints]]
name = "between"
between = ["low", "up"]
friction_angle_deg = 0
)",
                       friction_deg, stone, -width_up_m - 20, width_low_m, width_low_m, -fall_m(), -width_up_m,
                       rise_m(), -width_up_m - 20, rise_m(), width_low_m, -fall_m(), width_low_m,
                       height_m / 2 - fall_m(), height_m, height_m, -width_up_m, height_m, -width_up_m, rise_m());
  }
  /// By the force between the wedges: what the upper one presses with is what the lower one just holds.
  [[nodiscard]] double factor() const {
    const double up = width_up_m * (2 * height_m - rise_m()) / 2;
    const double low = width_low_m * (height_m + height_m / 2) / 2;
    double least = 0.01;
    double most = 100;
    for (int i = 0; i < 200; ++i) {
      const double f = std::sqrt(least * most);
      const double phi = std::atan(std::tan(friction_deg * degree) / f);
      const bool holds = up * std::tan(steep_deg * degree - phi) <= low * std::tan(phi - flat_deg * degree);
      (holds ? least : most) = f;
    }
    return least;
  }
};

TEST(SharpCorners, ACornerInAKinkIsToldWithTheFactorWithoutIt) {
  int told = 0;
  for (int seed = 1; seed <= campaign(20); ++seed) {
    independent::Random random(static_cast<std::uint64_t>(seed), "two wedges");
    const TwoWedges wedges{.steep_deg = random.between(25, 40),
                           .flat_deg = random.between(2, 12),
                           .width_up_m = random.between(3, 8),
                           .width_low_m = random.between(5, 12),
                           .height_m = random.between(7, 9),
                           .friction_deg = random.between(15, 24)};
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, wedges.text()));
    const scene::Scene scene = scene::read_text(wedges.text(), "wedges").scene;
    const solid::limit::LimitAnalysis structure(scene);
    const auto loads = statics::weights_of(scene);
    nlohmann::json answer = {{"warnings", nlohmann::json::array()}};
    solid::add_strength_with_crushed_corners(structure, loads, solid::limit::limit_strength(structure, loads), answer);
    ASSERT_TRUE(answer.contains("with_crushed_corners"));
    EXPECT_NEAR(answer["with_crushed_corners"]["factor"], wedges.factor(), 1e-7);
    EXPECT_THAT(answer["warnings"][0].get<std::string>(), ::testing::HasSubstr("and \"up\" at ("));
    ++told;
  }
  EXPECT_EQ(told, campaign(20));
}

}  // namespace
}  // namespace blockweir::test::sharp_corners_test
