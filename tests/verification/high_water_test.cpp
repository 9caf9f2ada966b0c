// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_answers fluid_hydrostatic bridge_scene_read
// Factors of safety under water far above all that can move, against the block's own equilibrium.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "tests/independent/random_structures.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::test::high_water_test {
namespace {

/// A parapet on a fixed wall, one or both pools above it.
TEST(HighWater, AParapetsFactorIsThatOfTheLevelStated) {
  for (int seed = 1; seed <= campaign(12); ++seed) {
    independent::Random random(static_cast<std::uint64_t>(seed), "high water");
    const double height = random.between_orders(0.3, 3);
    const double width = random.between(3, 6) * height;
    const double wall = random.between(0, 12) * height;
    const double up = random.between(1.2, 8) * height;
    const double down = random.chance(0.5) ? random.between(0, 0.8) * up : 0;
    const double friction_deg = random.between(20, 40);
    const std::string text =
        fmt::format(R"(analysis = {{ duration_s = 1, rigid = "all" }}
joint = {{ friction_angle_deg = {} }}
water = {{ upstream_level_m = {}, downstream_level_m = {}, may_overtop = true }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }}
[[block]]
name = "wall"
material = "m"
fixed = true
vertices_m = [[0, {}], [{}, {}], [{}, 0], [0, 0]]
[[block]]
name = "parapet"
material = "m"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
)",
                    friction_deg, up, down, -wall - height, width, -wall - height, width, width, width, height, height);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, text));
    const scene::Scene scene = scene::read_text(text, "parapet").scene;
    const auto answer = process::safety_answer(scene, [](const scene::Scene& risen, const std::filesystem::path&) {
      return std::make_unique<hydrostatic::HydrostaticModel>(risen);
    });
    const auto thrust = [&](double level) {  // on one side, up to the parapet's crest
      const double dry = std::max(0.0, level - height);
      return 9810 * (level * level - dry * dry) / 2;
    };
    const double on_crest = 9810 * std::max(0.0, down - height) * width;  // what stands there; the nappe is left out
    const double weight = 2400 * 9.81 * width * height + on_crest;
    const double factor = weight * std::tan(friction_deg * std::numbers::pi / 180) / (thrust(up) - thrust(down));
    EXPECT_NEAR(answer["limit_analysis_factor"], factor, 1e-4 * factor);
    EXPECT_NEAR(answer["factor"], factor, 1e-4 * factor);
  }
}

}  // namespace
}  // namespace blockweir::test::high_water_test
