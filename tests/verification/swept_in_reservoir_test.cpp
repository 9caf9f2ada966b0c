// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch fluid_reservoir bridge_schedule
// Blocks on each other slide beside a reservoir that joins their inertia: by sweeps as by Newton's method.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/uniform.hpp"
#include "bridge/scene/read/read.hpp"
#include "tests/verification/blocks_and_reservoir.hpp"

namespace blockweir::solid::swept_in_reservoir_test {
namespace {

/// A dam of some rows on slippery rock, with a push on each. One solution is too few for Newton's method.
scene::Scene dam(int seed, int rows, bool by_sweeps) {
  geometry::Uniform random(static_cast<std::uint64_t>(seed));
  const auto between = [&](double a, double b) { return a + (b - a) * random(); };
  const double height_m = between(5, 10);
  const double width_m = between(4, 8);
  std::string text = fmt::format(
      R"(analysis = {{ duration_s = 0.05, step_s = 0.002, rigid = "all", start = "unstressed" }}
contact = {{ max_iterations = {} }}
water = {{ upstream_level_m = {} }}
fluid = {{ model = "reservoir", reservoir = {{ element_ratio = 0.5 }} }}
joint = {{ friction_angle_deg = {} }}
material.m = {{ youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[{}, -3], [24, -3], [24, 0], [{}, 0]]
)",
      by_sweeps ? 1 : 200, between(0.6, 0.95) * height_m, seed % 2 == 0 ? 0 : between(2, 8), -2 * height_m,
      -2 * height_m);
  double low_m = 0;
  for (int row = 0; row < rows; ++row) {
    const double high_m = row + 1 == rows ? height_m : low_m + (height_m - low_m) * between(0.2, 0.6);
    text += fmt::format(
        "[[block]]\nname = \"d{0}\"\nmaterial = \"m\"\nvertices_m = [[0, {1}], [{3}, {1}], [{3}, {2}], [0, {2}]]\n"
        "[[point_load]]\nblock = \"d{0}\"\npoint_m = [{4}, {5}]\nforce_n_per_m = [{6}, 0]\n",
        row, low_m, high_m, width_m, width_m / 2, (low_m + high_m) / 2, between(-6e4, 6e4));
    low_m = high_m;
  }
  return scene::read_text(text, "dam").scene;
}

TEST(SweptInReservoir, BlocksSlideAsByNewtonsMethod) {
  for (int seed = 0; seed < 12; ++seed) {
    const int rows = 2 + seed % 4;
    SCOPED_TRACE(fmt::format("seed {}, {} rows", seed, rows));
    const scene::Scene scene = dam(seed, rows, false);
    const scene::Scene swept_scene = dam(seed, rows, true);
    Blocks blocks(scene);
    Blocks swept(swept_scene);
    run_with_reservoir(scene, blocks);
    run_with_reservoir(swept_scene, swept);
    ASSERT_GT(swept.solid.counts().swept_islands, 0);
    double fastest = 0;
    double off = 0;
    for (std::size_t b = 1; b < blocks.solid.states().size(); ++b) {
      const Vector6& velocity = blocks.solid.states()[b].velocity;
      fastest = std::max(fastest, velocity.head<2>().norm());
      off = std::max(off, (velocity - swept.solid.states()[b].velocity).head<3>().norm());
    }
    EXPECT_LE(off, 1e-3 * fastest + 1e-6) << "of " << fastest << " m/s";
  }
}

}  // namespace
}  // namespace blockweir::solid::swept_in_reservoir_test
