// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_answers fluid_hydrostatic fluid_reservoir bridge_scene_read bridge_schedule
// Walls that bend and strain before a reservoir that carries sound: blocks and water make each window as one step.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tests/verification/swinging_wall.hpp"

namespace blockweir::solid::bending_with_sound_test {
namespace {

constexpr double height = 40;
constexpr double depth = 38;
constexpr double thickness = 6;

std::string sound(double speed_m_per_s) {
  return fmt::format("compressible = true, sound_speed_m_per_s = {}", speed_m_per_s);
}

/// First frequency of a cantilever before a long reservoir, by Ritz with z^2 to z^6. The water's pressure is a sum over
/// cos(l z), l = (2q - 1) pi/2H; at the frequency w its added mass is 2 rho/(H (l^2 - w^2/c^2)^(1/2)) (Chopra 1967).
double cantilever(double density_kg_per_m3, double sound_speed_m_per_s) {
  constexpr int terms = 5;
  constexpr int points = 2000;
  const double bending = 25e9 / (1 - 0.2 * 0.2) * std::pow(thickness, 3) / 12;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(terms, terms);
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(terms, terms);
  for (int i = 0; i < terms; ++i) {
    for (int j = 0; j < terms; ++j) {
      K(i, j) = bending * (i + 2) * (i + 1) * (j + 2) * (j + 1) / (i + j + 1) / std::pow(height, 3);
      M(i, j) = density_kg_per_m3 * thickness * height / (i + j + 5);
    }
  }
  double omega = 0;
  for (int turn = 0; turn < 12; ++turn) {
    Eigen::MatrixXd wet = M;
    for (int q = 1; q <= 100; ++q) {
      const double l = (2 * q - 1) * std::numbers::pi / (2 * depth);
      Eigen::VectorXd share = Eigen::VectorXd::Zero(terms);
      for (int k = 0; k < points; ++k) {
        const double z = (k + 0.5) * depth / points;
        for (int i = 0; i < terms; ++i) share[i] += std::pow(z / height, i + 2) * std::cos(l * z) * depth / points;
      }
      wet += 2000 / depth / std::sqrt(l * l - std::pow(omega / sound_speed_m_per_s, 2)) * share * share.transpose();
    }
    omega = std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, wet).eigenvalues()[0]);
  }
  return omega;
}

struct Case {
  Wall wall;
  double sound_speed_m_per_s;
};

class BendingWithSound : public testing::TestWithParam<Case> {};

TEST_P(BendingWithSound, SwingsAsTheWaveEquationHasIt) {
  auto [wall, c] = GetParam();
  const double slower = cantilever(wall.density_kg_per_m3, c) / cantilever(wall.density_kg_per_m3, 1e9);
  const double expected = wet_frequency(wall) * slower;
  wall.water = sound(c);
  const Swing swing = swing_of(wall, expected);
  EXPECT_NEAR(swing.omega / expected, 1, 1e-3);
  EXPECT_LT(swing.growth, 1.05);
  EXPECT_GT(swing.growth, 0.5);
}

/// With sound of 1e5 m/s the water is as good as incompressible; at 500 m/s the wall is 1.3 % slower.
INSTANTIATE_TEST_SUITE_P(Walls, BendingWithSound,
                         testing::Values(Case{{}, 1e5}, Case{{.schedule = "improved"}, 500},
                                         Case{{.integrator = "generalized-alpha"}, 1440},
                                         Case{{.integrator = "shi", .step_s = 0.001, .duration_s = 1.2}, 1440},
                                         Case{{.density_kg_per_m3 = 300}, 1440}));

/// Where the water is far heavier than the wall, and steps do not resolve the wall's higher modes.
TEST(LightWallsWithSound, GainNoEnergy) {
  for (const char* integrator : {"trapezoidal", "generalized-alpha", "shi"}) {
    const Wall wall{.integrator = integrator,
                    .mesh_size_m = 8,
                    .density_kg_per_m3 = 1,
                    .step_s = 0.008,
                    .water = sound(1440) + ", element_ratio = 0.5",
                    .duration_s = 4};
    const scene::Scene scene = scene::read_text(text_of(wall), "wall").scene;
    Recorded blocks(scene);
    run_with_reservoir(scene, blocks);
    EXPECT_LT(growth_of(blocks.kinetic), 1.05) << integrator;
  }
}

/// Motion of the wall beside that of its ground, at the end.
double shaken(const char* form) {
  const Wall wall{.mesh_size_m = 8, .step_s = 0.004, .water = sound(1440) + ", element_ratio = 0.5", .duration_s = 1.2};
  const scene::Scene scene =
      scene::read_text(text_of(wall) + "[base_motion]\nform = \"" + form +
                           "\"\nacceleration_x_m_per_s2 = { table = [[0, 0], [0.3, 1], [0.6, -1], [0.9, 0]] }\n",
                       "shaken")
          .scene;
  Blocks blocks(scene);
  run_with_reservoir(scene, blocks);
  return blocks.solid.states()[1].displacement[0] - blocks.solid.states()[0].displacement[0];
}

TEST(GroundBeforeSound, ShakesAWallAlikeInBothForms) {
  const double relative = shaken("inertia");
  EXPECT_NEAR(shaken("support"), relative, 0.005 * std::abs(relative));
}

}  // namespace
}  // namespace blockweir::solid::bending_with_sound_test
