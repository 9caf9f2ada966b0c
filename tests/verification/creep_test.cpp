// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic nlohmann_json::nlohmann_json bridge_scene_read
// A dam on joints that dip, with next to no strength too little: it creeps for hundreds of static steps.
#include <gtest/gtest.h>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "solid/capacity/static_strength.hpp"

namespace blockweir::test::creep_test {
namespace {

const char* const dam = R"(analysis = { duration_s = 1 }
joint = { friction_angle_deg = 43.53, uplift = "triangular" }
water = { upstream_level_m = 6.9075 }
material.m = { youngs_modulus_pa = 19.4e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-19, -7.5], [29, -7.5], [29, -1.5426], [7.4587, -1.5426], [0, 0], [-19, 0]]
[[block]]
name = "low"
material = "m"
vertices_m = [[0, 0], [7.4587, -1.5426], [4.45, 3.8881], [0, 5.4793]]
[[block]]
name = "top"
material = "m"
vertices_m = [[0, 5.4793], [4.45, 3.8881], [1.3088, 9.5578], [0, 9.5578]]
)";

/// One takes as long to try as a hundred others.
TEST(Creep, StepsThatFindNoStatesAreNotTriedAgainAfterEachThatDoes) {
  const scene::Scene scene = scene::read_text(dam, "dam").scene;
  solid::StillWater water(scene, hydrostatic::make);
  const double level_m = scene.water.upstream_level_m->at(1);
  const double factor = solid::static_strength(scene, &water, level_m, 1.9).factor;
  long most_steps = 0;
  for (double above = 1e-7; above < 1e-5; above *= 1.5) {
    const scene::Scene reduced = solid::with_reduced_strength(scene, factor * (1 + above));
    solid::SearchBudget effort("creep");
    solid::StaticBlocks blocks(reduced, &water, effort);
    EXPECT_FALSE(blocks.begin(level_m)) << above;
    const solid::Solid& solid = blocks.solid();
    EXPECT_LT(solid.counts().softened_steps, 50) << above << ' ' << solid.state().rest.steps;
    most_steps = std::max<long>(most_steps, solid.state().rest.steps);
  }
  EXPECT_GT(most_steps, 200);  // else nothing has crept
}

}  // namespace
}  // namespace blockweir::test::creep_test
