// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch fluid_reservoir bridge_schedule
// A rigid dam slides in one pulse of the ground while its reservoir answers: Newmark's slip, on all schedules, whatever
// the number of windows and however often the water is meshed anew.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/read/read.hpp"
#include "tests/verification/blocks_and_reservoir.hpp"

namespace blockweir::solid::slide_on_reservoir_test {
namespace {

constexpr double pulse_s = 0.4;
constexpr double slip = 0.138208;  // over A T^2, at A of twice the acceleration at which it begins

/// 50 m high, 40 m wide, of 2,400 kg/m3, on a joint of 38 degrees. Water meshed anew every 5 mm.
scene::Scene dam(const char* schedule, int windows_a_second) {
  scene::Scene scene = scene::read_text(R"(
analysis = { duration_s = 0.8, rigid = "all", failure_displacement_m = 1 }
water = { upstream_level_m = 50 }
fluid = { model = "reservoir", reservoir = { element_ratio = 0.5, move_tolerance = 1e-4 } }
joint = { friction_angle_deg = 38 }
material.m = { youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
base_motion = { acceleration_x_m_per_s2 = 0.1 }
block = [ { name = "rock", material = "m", fixed = true, vertices_m = [[-50, -20], [90, -20], [90, 0], [-50, 0]] },
          { name = "dam", material = "m", vertices_m = [[0, 0], [40, 0], [0, 50]] } ]
coupling = { schedule = ")" + std::string(schedule) +
                                            "\" }\n",
                                        "dam")
                           .scene;
  scene.coupling.window_s = scene.analysis.step_s = 1.0 / windows_a_second;
  return scene;
}

/// At which the dam begins to slide, downstream, with the reservoir's mesh as it is [m/s2].
double yield_acceleration(const scene::Scene& scene) {
  reservoir::ReservoirModel water(scene);
  wire::Motion at_rest;
  at_rest.displacement.own().resize(2);
  at_rest.velocity.own().resize(2);
  wire::Load load;
  water.advance(at_rest, 0, load);
  const double mass = 2400 * 40 * 50 / 2.0;
  const double still = scene.water.density_kg_per_m3 * 9.81 * 50 * 50 / 2;
  const double friction = std::tan(38 * std::numbers::pi / 180) * mass * 9.81;
  return (friction - still) / (mass + load.added_mass[1][0]);
}

void shake(scene::Scene& scene, double amplitude) {
  scene::TimeTable pulse{{}, {}};
  constexpr int rows = 400;
  for (int i = 0; i <= rows; ++i) {
    pulse.time_s.push_back(pulse_s * i / rows);
    pulse.value.push_back(-amplitude * std::sin(std::numbers::pi * i / rows));
  }
  scene.base_motion->acceleration_x_m_per_s2 = pulse;
}

/// Of the slip, relative.
double error_of(const char* schedule, int windows_a_second) {
  scene::Scene scene = dam(schedule, windows_a_second);
  const double amplitude = 2 * yield_acceleration(scene);
  shake(scene, amplitude);
  Blocks blocks(scene);
  run_with_reservoir(scene, blocks);
  return blocks.solid.states()[1].displacement[0] / (slip * amplitude * pulse_s * pulse_s) - 1;
}

TEST(SlideOnReservoir, SlipsAsNewmarksBlockWithFirstOrderInTheWindow) {
  for (const char* schedule : {"serial", "parallel"}) {
    for (const int windows : {100, 141, 200, 283, 400, 800}) {
      EXPECT_LT(std::abs(error_of(schedule, windows)), 0.3 / windows) << schedule << " " << windows;
    }
  }
}

TEST(SlideOnReservoir, SlipsWithSecondOrderOnTheImprovedSchedule) {
  for (const int windows : {100, 141, 200, 283, 400, 566, 800, 1600}) {
    EXPECT_LT(std::abs(error_of("improved", windows)), 25.0 / windows / windows + 5e-5) << windows;
  }
}

}  // namespace
}  // namespace blockweir::solid::slide_on_reservoir_test
