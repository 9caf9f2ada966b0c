// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch bridge_scene_read
// Blocks that rock on viscous ground make no energy there, whichever way the ground's record comes in.
#include <gtest/gtest.h>

#include <cmath>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/energy.hpp"

namespace blockweir::solid::energy_on_viscous_ground_test {
namespace {

/// A tower of two stones on ground that a record of 6 m/s2 shakes.
scene::Scene tower(const std::string& form, const std::string& integrator) {
  return scene::read_text("analysis = { duration_s = 2, step_s = 0.01, failure_displacement_m = 100, integrator = \"" +
                              integrator + "\" }\n[base_motion]\nform = \"" + form + R"("
acceleration_x_m_per_s2 = { sine = 6, frequency_hz = 1.5 }
[material.rock]
youngs_modulus_pa = 20e9
poissons_ratio = 0.2
density_kg_per_m3 = 2500
[joint]
friction_angle_deg = 40
[[block]]
name = "ground"
material = "rock"
vertices_m = [[-20, -10], [20, -10], [20, 0], [-20, 0]]
[[block]]
name = "tower"
material = "rock"
vertices_m = [[-1, 0], [1, 0], [1, 6], [-1, 6]]
[[block]]
name = "stone"
material = "rock"
vertices_m = [[-1, 6], [1, 6], [1, 8], [-1, 8]]
[[viscous_boundary]]
)",
                          "tower.toml")
      .scene;
}

TEST(EnergyOnViscousGround, IsNotMadeWhereBlocksRock) {
  for (const std::string integrator : {"shi", "generalized-alpha"}) {
    for (const std::string form : {"support", "inertia"}) {
      const scene::Scene scene = tower(form, integrator);
      Solid solid(scene);
      solid.settle({});
      EnergyWatch energy;
      energy.look(solid);
      for (int n = 0; n < 200; ++n) {
        solid.advance(n * 0.01, (n + 1) * 0.01, {});
        energy.look(solid);
      }
      EXPECT_LT(energy.gain(), 1e-8) << integrator << ' ' << form;
      EXPECT_GT(solid.largest_displacement_m(), 1e-3);  // it has rocked
    }
  }
}

}  // namespace
}  // namespace blockweir::solid::energy_on_viscous_ground_test
