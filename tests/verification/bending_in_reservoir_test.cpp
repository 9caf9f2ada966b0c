// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic fluid_reservoir bridge_scene_read bridge_schedule
// Walls that bend and strain before a reservoir: a run swings with the frequency of structure and water as they are
// solved for together, whatever damps it or not, and loses or gains nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/watch/energy.hpp"
#include "tests/verification/blocks_and_reservoir.hpp"

namespace blockweir::solid {
namespace {

struct Wall {
  const char* schedule = "serial";
  const char* integrator = "trapezoidal";
  double mesh_size_m = 4;  ///< 0: it strains evenly
  double density_kg_per_m3 = 2400;
  double step_s = 0.002;
  const char* water = "";  ///< keys of the reservoir
};

/// 40 m high and 6 m thick, glued to rock; its crest is pushed from the start on.
std::string text_of(const Wall& wall) {
  return fmt::format(R"(coupling = {{ schedule = "{}", window_s = {} }}
water = {{ upstream_level_m = 38 }}
fluid = {{ model = "reservoir", reservoir = {{ {} }} }}
material.m = {{ youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = {} }}
joint = {{ friction_angle_deg = 45, cohesion_pa = 1e9, tension_strength_pa = 1e9 }}
point_load = [ {{ block = "wall", point_m = [6, 40], force_n_per_m = [1e4, 0] }} ]
[analysis]
duration_s = 2.4
step_s = {}
gravity_m_per_s2 = 0
start = "unstressed"
integrator = "{}"
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-30, -10], [50, -10], [50, 0], [-30, 0]]
[[block]]
name = "wall"
material = "m"
{}
vertices_m = [[0, 0], [6, 0], [6, 40], [0, 40]]
)",
                     wall.schedule, wall.step_s, wall.water, wall.density_kg_per_m3, wall.step_s, wall.integrator,
                     wall.mesh_size_m > 0 ? fmt::format("mesh_size_m = {}", wall.mesh_size_m) : "");
}

double wet_frequency(const Wall& wall) {
  const auto answer =
      process::modes_answer(scene::read_text(text_of(wall), "wall").scene, hydrostatic::make, reservoir::mass_on_faces);
  return answer["wet"][0]["omega_rad_per_s"].get<double>();
}

/// Mean motion of the wall along x, and its kinetic energy, after each window.
class Recorded : public Blocks {
 public:
  using Blocks::Blocks;
  void record() override {
    moved.push_back(solid.states()[1].displacement[0]);
    kinetic.push_back(energy_of(solid).kinetic);
  }
  std::vector<double> moved;
  std::vector<double> kinetic;
};

struct Swing {
  double omega;
  double growth;  ///< largest kinetic energy of the second half over that of the first
};

/// What is left of the motion beside the best c0 + c1 cos(w t) + c2 sin(w t).
double left_beside(double omega, const std::vector<double>& moved, double step_s) {
  Eigen::MatrixX3d terms(static_cast<Eigen::Index>(moved.size()), 3);
  for (Eigen::Index i = 0; i < terms.rows(); ++i) {
    const double phase = omega * step_s * static_cast<double>(i);
    terms.row(i) << 1, std::cos(phase), std::sin(phase);
  }
  const auto y = Eigen::Map<const Eigen::VectorXd>(moved.data(), terms.rows());
  return (y - terms * terms.householderQr().solve(y)).norm();
}

Swing swing_of(const Wall& wall, double near) {
  const scene::Scene scene = scene::read_text(text_of(wall), "wall").scene;
  Recorded blocks(scene);
  run_with_reservoir(scene, blocks);
  Swing swing{near, 0};
  double least = std::numeric_limits<double>::infinity();
  for (double omega = 0.95 * near; omega < 1.05 * near; omega += 1e-4 * near) {
    const double left = left_beside(omega, blocks.moved, wall.step_s);
    if (left < least) least = left, swing.omega = omega;
  }
  const auto half = static_cast<std::ptrdiff_t>(blocks.kinetic.size() / 2);
  swing.growth = *std::max_element(blocks.kinetic.end() - half, blocks.kinetic.end()) /
                 *std::max_element(blocks.kinetic.begin(), blocks.kinetic.begin() + half);
  return swing;
}

class BendingInReservoir : public testing::TestWithParam<Wall> {};

TEST_P(BendingInReservoir, SwingsAsStructureAndWaterTogetherAndGainsNoEnergy) {
  const double exact = wet_frequency(GetParam());
  const Swing swing = swing_of(GetParam(), exact);
  EXPECT_NEAR(swing.omega / exact, 1, 5e-4);
  EXPECT_LT(swing.growth, 1.05);
  EXPECT_GT(swing.growth, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Walls, BendingInReservoir,
                         testing::Values(Wall{}, Wall{.schedule = "parallel"}, Wall{.schedule = "improved"},
                                         Wall{.integrator = "shi", .step_s = 0.001}, Wall{.density_kg_per_m3 = 300},
                                         Wall{.mesh_size_m = 0, .step_s = 0.0005}));

/// A light wall with sloping faces on ice, pressed down by a load of 13.7 MN/m that acts at once, and pushed.
scene::Scene wall_on_ice(double youngs_modulus_pa, const char* schedule) {
  return scene::read_text(fmt::format(R"(coupling = {{ schedule = "{}", window_s = 0.002 }}
joint = {{ friction_angle_deg = 0 }}
water = {{ upstream_level_m = 7.3 }}
fluid = {{ model = "reservoir", reservoir = {{ upstream_wall_m = -12 }} }}
material.m = {{ youngs_modulus_pa = {}, poissons_ratio = 0.2, density_kg_per_m3 = 50 }}
point_load = [ {{ block = "wall", point_m = [3.8, 0], force_n_per_m = [0, -1.37e7] }} ]
body_load = [ {{ blocks = ["wall"], force_x_n_per_m3 = 300 }} ]
[analysis]
duration_s = 0.1
step_s = 0.002
gravity_m_per_s2 = 0
start = "unstressed"
integrator = "trapezoidal"
max_displacement_ratio = 1
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-12, -3], [22, -3], [22, 0], [-12, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [7.6, 0], [6.2, 7.5], [1.6, 7.5]]
)",
                                      schedule, youngs_modulus_pa),
                          "ice")
      .scene;
}

/// Its damping, which begins as it slides, takes nothing of that.
TEST(StrainInReservoir, AWallThatBeginsToSlideHasTheMomentumOfItsLoad) {
  for (const char* schedule : {"serial", "parallel", "improved"}) {
    for (const double youngs_modulus_pa : {1e9, 1e10, 1e11}) {
      const scene::Scene scene = wall_on_ice(youngs_modulus_pa, schedule);
      Blocks blocks(scene);
      run_with_reservoir(scene, blocks);
      const Block& wall = blocks.solid.blocks()[1];
      const double exact = 300 * wall.area * 0.1 / (wall.mass_per_m() + blocks.masses.own[1](0, 0));
      EXPECT_NEAR(blocks.solid.states()[1].velocity[0] / exact, 1, 2e-3) << schedule << youngs_modulus_pa;
    }
  }
}

}  // namespace
}  // namespace blockweir::solid
