// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Walls of many rigid bricks on ground that is led: seen from the ground, they move as under the forces of inertia.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::solid::shaken_bricks_test {
namespace {

constexpr double duration_s = 0.6;

/// Shaken sideways by up to `share` of what friction bears, and up and down.
std::string wall(test::Random any, double share, const char* form) {
  const double friction_deg = any.between(20, 40);
  const double sideways = share * 9.81 * std::tan(friction_deg * std::numbers::pi / 180);
  return fmt::format(R"(analysis = {{ duration_s = {}, step_s = 0.002, rigid = "all" }}
joint = {{ friction_angle_deg = {} }}
material.m = {{ youngs_modulus_pa = 2e10, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[base_motion]
form = "{}"
acceleration_x_m_per_s2 = {{ table = [[0, 0], [0.1, {}], [0.4, {}], [0.6, 0]] }}
acceleration_y_m_per_s2 = {{ table = [[0, 0], [0.2, {}], [0.6, 0]] }}
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[-20, -2], [20, -2], [20, 0], [-20, 0]]
[[wall]]
name = "w"
material = "m"
bond = "{}"
brick_length_m = {}
brick_height_m = {}
rows = {}
columns = {}
)",
                     duration_s, friction_deg, form, sideways, -sideways, any.between(-1, 1),
                     any.integer(0, 1) == 0 ? "stacked" : "running", any.between(0.8, 1.5), any.between(0.1, 0.2),
                     any.integer(2, 3), any.integer(7, 14));
}

/// Of its blocks at the end, as the inertia of a base at rest moves them.
std::vector<Eigen::Vector3d> moved_from_base(const std::string& text) {
  const scene::Scene scene = scene::read_text(text, "wall").scene;
  Solid solid(scene);
  solid.settle({});
  solid.advance(0, duration_s, {});
  const auto fixed = solid.states()[0].displacement.head<3>();
  std::vector<Eigen::Vector3d> moved;
  for (std::size_t b = 1; b < solid.described(); ++b) moved.push_back(solid.states()[b].displacement.head<3>() - fixed);
  return moved;
}

void expect_the_same(unsigned seed, double share, double least_m, double most_m, double off_m) {
  const auto led = moved_from_base(wall(test::Random(seed), share, "support"));
  const auto pushed = moved_from_base(wall(test::Random(seed), share, "inertia"));
  ASSERT_GT(led.size(), 13U);
  double farthest_m = 0;
  for (std::size_t b = 0; b < led.size(); ++b) {
    farthest_m = std::max(farthest_m, pushed[b].head<2>().norm());
    EXPECT_LT((led[b] - pushed[b]).norm(), off_m) << "seed " << seed << ", block " << b;
  }
  EXPECT_GE(farthest_m, least_m) << seed;
  EXPECT_LE(farthest_m, most_m) << seed;
}

TEST(ShakenBricks, RideWithTheGroundBelowTheirFriction) {
  for (int seed = 1; seed <= test::campaign(4); ++seed)
    expect_the_same(static_cast<unsigned>(seed), 0.7, 0, 1e-6, 1e-6);
}

TEST(ShakenBricks, SlideAsUnderForcesOfInertia) {
  for (int seed = 1; seed <= test::campaign(4); ++seed)
    expect_the_same(static_cast<unsigned>(seed), 1.3, 1e-3, 1, 1e-3);
}

}  // namespace
}  // namespace blockweir::solid::shaken_bricks_test
