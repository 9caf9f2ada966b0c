// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Ramps without `to` end where the scene's own duration ends them, in a run that lasts longer.
#include <fmt/format.h>

#include <random>

#include "bridge/scene/read/ramp_ends.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::ramp_ends_test {
namespace {

using namespace blockweir::scene;

TEST(RampEnds, HoldWhatARampHasReachedAndLeaveTheRestAsItIs) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const auto quarter = [&](unsigned most) { return 0.25 * static_cast<double>(random() % (4 * most)); };
    const double from = quarter(2);
    const double rate = 0.125 + quarter(1) / 8;
    const double duration_s = 1 + quarter(4);
    const std::string text = fmt::format(
        "[analysis]\nduration_s = {}\n[joint]\nfriction_angle_deg = 30\n[material.m]\nyoungs_modulus_pa = 1e10\n"
        "poissons_ratio = 0.2\ndensity_kg_per_m3 = 2300\n[[block]]\nname = 'g'\nmaterial = 'm'\nfixed = true\n"
        "vertices_m = [[-10, -3], [12, -3], [12, 0], [-10, 0]]\n[[block]]\nname = 'w'\nmaterial = 'm'\n"
        "vertices_m = [[0, 0], [2.5, 0], [1, 9], [0, 9]]\n"
        "[[point_load]]\nblock = 'w'\npoint_m = [0, 9]\nforce_n_per_m = [1, 0]\n"
        "[water]\nupstream_level_m = {{ from = {}, rate_per_s = {} }}\n"
        "downstream_level_m = {{ from = 0, to = 0.5, rate_per_s = 1 }}\n",
        duration_s, from, rate);
    const Scene own = read_text(text, "s.toml").scene;
    std::vector<std::string> longer = ramp_ends(own);
    ASSERT_EQ(longer.size(), 1U) << text;
    longer.push_back("analysis.duration_s=100");
    const Scene scene = read_text(text, "s.toml", longer).scene;
    EXPECT_DOUBLE_EQ(scene.water.upstream_level_m->at(100), own.water.upstream_level_m->at(duration_s));
    EXPECT_DOUBLE_EQ(scene.water.upstream_level_m->at(duration_s / 2), own.water.upstream_level_m->at(duration_s / 2));
    EXPECT_EQ(scene.water.downstream_level_m, own.water.downstream_level_m);
  }
}

}  // namespace
}  // namespace blockweir::ramp_ends_test
