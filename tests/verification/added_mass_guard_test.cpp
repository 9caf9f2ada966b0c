// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch
// Blocks against water that answers their acceleration one window late, as an explicit schedule has it: exact answers
// with the guard, growth without.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "solid/watch/energy.hpp"
#include "tests/verification/coupled_block.hpp"

namespace blockweir::solid::added_mass_guard_test {
namespace {

TEST(AddedMassGuard, ASteadyPushAcceleratesBlockAndWaterAsOneFromTheFirstWindow) {
  for (const Kind kind : {Kind::rigid, Kind::deformable, Kind::meshed}) {
    for (const auto integrator : integrators) {
      for (const int steps : {1, 4}) {
        for (const double ratio : {0.2, 0.8, 1.5, 3.0, 10.0, 100.0}) {
          auto scene = free_block(kind, integrator, steps);
          push(scene, mass);
          const auto places = course({.scene = scene, .inertia = added(ratio * mass)}, 50);
          const double expected = 1 / (1 + ratio) * 0.5 * 0.5 / 2;
          EXPECT_NEAR(places.back()[0] / expected, 1, kind == Kind::rigid ? 1e-9 : 1e-4)
              << name_of(kind) << " " << static_cast<int>(integrator) << " " << steps << " " << ratio;
        }
      }
    }
  }
}

/// Mean period of a spring's oscillation over five of them, over the exact one [1].
double period_ratio(const Coupled& run, double period_s) {
  const auto places = course(run, static_cast<int>(5.5 * period_s / window_s));
  std::vector<double> crossings;
  for (std::size_t n = 1; n + 1 < places.size(); ++n) {
    const double a = places[n][0];
    const double b = places[n + 1][0];
    if (a * b < 0) crossings.push_back((static_cast<double>(n) + a / (a - b)) * window_s);
  }
  if (crossings.size() < 10) return 0;
  return (crossings[9] - crossings[1]) / 4 / period_s;
}

TEST(AddedMassGuard, ASpringHasThePeriodOfBlockAndWater) {
  const double period_s = 1;
  const double omega = 2 * std::numbers::pi / period_s;
  for (const Kind kind : {Kind::rigid, Kind::deformable, Kind::meshed}) {
    for (const auto integrator : integrators) {
      for (const double ratio : {0.2, 0.8, 1.5, 3.0, 10.0}) {
        for (const double guess : {0.6, 1.0, 1.5}) {
          for (const Seen seen : {Seen::velocities, Seen::positions}) {
            if (kind == Kind::meshed && (guess != 1 || integrator != scene::Integrator::shi)) continue;  // slower
            auto scene = free_block(kind, integrator);
            scene.blocks[0].initial_velocity_m_per_s = Point(0.1, 0);
            spring(scene, (1 + ratio) * mass * omega * omega);
            const Coupled run{.scene = scene, .inertia = added(ratio * mass), .guess = guess, .seen = seen};
            // 11/96 and 1/12 (omega dt)^2 are the schemes' own: 4.5e-4 and 3.3e-4.
            const bool exact = guess == 1 && seen == Seen::velocities;
            EXPECT_NEAR(period_ratio(run, period_s), 1, exact ? 5e-4 : 3e-3)
                << name_of(kind) << " " << static_cast<int>(integrator) << " m_a/m " << ratio << " guess " << guess
                << (seen == Seen::velocities ? " velocities" : " positions");
          }
        }
      }
    }
  }
}

TEST(AddedMassGuard, WithoutItAPushGrowsByTheRatioAWindow) {
  for (const double ratio : {0.2, 0.8, 1.5, 3.0, 10.0}) {
    const double push_m_per_s2 = 1e-5;
    auto scene = free_block(Kind::rigid, scene::Integrator::shi);
    push(scene, push_m_per_s2 * mass);
    Solid solid(scene);
    AnsweringWater water(added(ratio * mass), Seen::velocities);
    double exact = 0;
    for (int n = 0; n < 8; ++n) {
      const double before = solid.states()[0].velocity[0];
      solid.advance(n * window_s, (n + 1) * window_s, water.answer(solid));
      exact = push_m_per_s2 - ratio * exact;
      EXPECT_NEAR((solid.states()[0].velocity[0] - before) / window_s / exact, 1, 1e-3) << ratio << " " << n;
    }
    const double alternating = std::abs(exact / push_m_per_s2 - 1 / (1 + ratio));  // about what is right
    EXPECT_NEAR(alternating * (1 + ratio) / std::pow(ratio, 8), 1, 1e-9);
  }
}

TEST(AddedMassGuard, ASpringStaysStableWhateverTheRatioWithAGuessThatIsOff) {
  for (const double ratio : {0.2, 0.8, 1.5, 3.0, 10.0, 100.0}) {
    for (const double guess : {0.6, 1.0, 1.5}) {
      for (const Seen seen : {Seen::velocities, Seen::positions}) {
        auto scene = free_block(Kind::deformable, scene::Integrator::shi);
        scene.blocks[0].initial_velocity_m_per_s = Point(0.1, 0);
        spring(scene, (1 + ratio) * mass * 4 * std::numbers::pi * std::numbers::pi);
        const auto places =
            course({.scene = scene, .inertia = added(ratio * mass), .guess = guess, .seen = seen}, 1000);
        const auto largest = [&](std::size_t from, std::size_t to) {
          double most = 0;
          for (std::size_t n = from; n <= to; ++n) most = std::max(most, std::abs(places[n][0]));
          return most;
        };
        EXPECT_LT(largest(900, 1000), largest(0, 100)) << ratio << " " << guess;
        EXPECT_LT(largest(0, 100), 0.1) << ratio << " " << guess;
      }
    }
  }
}

TEST(AddedMassGuard, AForcesLeverTurnsTheBlockAsTheWholeMatrixSays) {
  // The water hangs on the face half a metre below the centroid, and resists turning too.
  const double m = 1.5 * mass;
  const Eigen::Matrix3d water = added(m, 0.5 * m, 0.25 * m + 0.8 * mass);
  Eigen::Matrix3d whole = water;
  whole.diagonal() += Eigen::Vector3d(mass, mass, mass * (width_m * width_m + height_m * height_m) / 12);
  const double force = 0.01 * mass;
  const Eigen::Vector3d expected = whole.inverse() * Eigen::Vector3d(force, 0, 0) * 0.5 * 0.5 / 2;
  for (const Kind kind : {Kind::rigid, Kind::deformable, Kind::meshed}) {
    for (const auto integrator : integrators) {
      auto scene = free_block(kind, integrator);
      push(scene, force);
      const auto places = course({.scene = scene, .inertia = water}, 50);
      EXPECT_NEAR(places.back()[0] / expected[0], 1, 1e-4) << name_of(kind) << " " << static_cast<int>(integrator);
      EXPECT_NEAR(places.back()[2] / expected[2], 1, 1e-4) << name_of(kind) << " " << static_cast<int>(integrator);
    }
  }
}

TEST(AddedMassGuard, LagrangeMultipliersGiveAMeshTheSameMotion) {
  std::vector<double> moved;
  for (const auto formulation :
       {scene::ContactFormulation::augmented_lagrangian, scene::ContactFormulation::lagrange_multiplier}) {
    auto scene = free_block(Kind::meshed, scene::Integrator::shi);
    scene.contact.formulation = formulation;
    scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 0;
    scene.analysis.gravity_m_per_s2 = 9.81;
    add(scene, {{-3, -2}, {3, -2}, {3, -1}, {-3, -1}}, true);
    push(scene, mass);
    Solid solid(scene);
    solid.settle({});
    AnsweringWater water(added(3 * mass), Seen::velocities);
    for (int n = 0; n < 30; ++n) {
      const auto panels = water.answer(solid);
      solid.advance(n * window_s, (n + 1) * window_s, panels, {added(3 * mass), Eigen::Matrix3d::Zero()});
    }
    moved.push_back(solid.states()[0].displacement[0]);
  }
  EXPECT_NEAR(moved[0] / (0.25 * 0.3 * 0.3 / 2), 1, 1e-3);
  EXPECT_NEAR(moved[1] / moved[0], 1, 1e-6);
}

TEST(AddedMassGuard, NoInertiaChangesNothingAndMotionsEnergyIsTheBlocksOwn) {
  auto scene = free_block(Kind::deformable, scene::Integrator::trapezoidal, 3);
  push(scene, mass);
  Solid without(scene);
  Solid with(scene);
  Solid heavy(scene);
  for (int n = 0; n < 20; ++n) {
    without.advance(n * window_s, (n + 1) * window_s, {});
    with.advance(n * window_s, (n + 1) * window_s, {}, {Eigen::Matrix3d::Zero()});
    heavy.advance(n * window_s, (n + 1) * window_s, {}, {added(3 * mass)});
  }
  EXPECT_EQ(with.states()[0].displacement, without.states()[0].displacement);
  const double speed = heavy.states()[0].velocity[0];
  EXPECT_NEAR(energy_of(heavy).kinetic / (mass * speed * speed / 2), 1, 1e-6);
}

TEST(AddedMassGuard, WhatRestsSleepsAndWakesToTheSameMotion) {
  std::vector<double> moved;
  for (const bool sleep : {true, false}) {
    auto scene = free_block(Kind::deformable, scene::Integrator::shi);
    scene.analysis.gravity_m_per_s2 = 9.81;
    scene.analysis.sleep = sleep;
    add(scene, {{-3, -2}, {3, -2}, {3, -1}, {-3, -1}}, true);
    push(scene, 0);
    scene.point_loads[0].force_x_n_per_m = {.time_s = {0, 0.5, 0.51}, .value = {0, 0, 9.81 * mass}};
    Solid solid(scene);
    solid.settle({});
    AnsweringWater water(added(3 * mass), Seen::velocities);
    for (int n = 0; n < 80; ++n) {
      const auto panels = water.answer(solid);
      solid.advance(n * window_s, (n + 1) * window_s, panels, {added(3 * mass), Eigen::Matrix3d::Zero()});
    }
    EXPECT_EQ(solid.counts().slept_islands > 40, sleep);
    moved.push_back(solid.states()[0].displacement[0]);
  }
  EXPECT_GT(moved[0], 0.01);
  EXPECT_NEAR(moved[0], moved[1], 1e-9);
}

}  // namespace
}  // namespace blockweir::solid::added_mass_guard_test
