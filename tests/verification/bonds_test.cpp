// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// The load at which bonds fail against the statics of a block on two contacts: random blocks, all formulations and
// integrators.
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::bonds_test {
namespace {

constexpr double g = 9.81;

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

class Bonds : public testing::TestWithParam<std::tuple<scene::ContactFormulation, scene::Integrator>> {
 protected:
  static constexpr double duration_s = 50;

  /// A block of that size on the ground, pushed along x by a share of its weight that grows from 0.3 to 1.01 of `load`.
  static scene::Scene pushed_block(double width, double height, const scene::JointLaw& law, double load) {
    auto scene = empty_scene();
    scene.materials[0].youngs_modulus_pa = 500e9;  // so that its statics are those of its outline
    scene.contact.formulation = std::get<0>(GetParam());
    scene.analysis.integrator = std::get<1>(GetParam());
    scene.analysis.step_s = 0.01;
    scene.analysis.duration_s = duration_s;
    scene.default_joint = law;
    add(scene, {{-100, -3}, {100, -3}, {100, 0}, {-100, 0}}, true);
    add(scene, {{0, 0}, {width, 0}, {width, height}, {0, height}});
    scene::BodyLoad push;
    push.blocks = {1};
    // Smoothly, or the undamped integrators would ring; by less than 3e-4 of it in a step.
    constexpr int rows = 5000;
    for (int i = 0; i <= rows; ++i) {
      const double done = static_cast<double>(i) / rows;
      push.value[0].time_s.push_back(done * duration_s);
      push.value[0].value.push_back((0.3 + 0.71 * done * done * (3 - 2 * done)) * load * g);
    }
    push.value[1] = scene::TimeTable::constant(0);
    scene.body_loads.push_back(push);
    return scene;
  }

  /// Load over the weight at which the joint fails, the first time that a bond is gone or nothing sticks; 0: it does
  /// not.
  static double load_at_failure(const scene::Scene& scene) {
    Solid solid(scene);
    solid.settle({});
    const double dt = scene.analysis.step_s;
    const auto& course = scene.body_loads[0].value[0];
    const auto failed = [&] {
      bool sticks = false;
      bool broken = false;
      for (const ContactPoint& c : solid.contacts()) {
        sticks = sticks || c.state == ContactState::stick;
        broken = broken || (c.bond_length > 0 && c.bond == 0);
      }
      return broken || !sticks;
    };
    for (int n = 0; n < std::lround(duration_s / dt); ++n) {
      if (failed()) return course.at((n - 0.5) * dt) / g;
      solid.advance(n * dt, (n + 1) * dt, {});
    }
    return 0;
  }
};

std::string name_of(const testing::TestParamInfo<Bonds::ParamType>& tested) {
  const auto formulation = std::get<0>(tested.param);
  const auto integrator = std::get<1>(tested.param);
  const std::string first = formulation == scene::ContactFormulation::penalty               ? "Penalty"
                            : formulation == scene::ContactFormulation::lagrange_multiplier ? "LagrangeMultiplier"
                                                                                            : "AugmentedLagrangian";
  return first + (integrator == scene::Integrator::shi           ? "Shi"
                  : integrator == scene::Integrator::trapezoidal ? "Trapezoidal"
                                                                 : "GeneralizedAlpha");
}

INSTANTIATE_TEST_SUITE_P(Ways, Bonds,
                         testing::Combine(testing::Values(scene::ContactFormulation::augmented_lagrangian,
                                                          scene::ContactFormulation::lagrange_multiplier,
                                                          scene::ContactFormulation::penalty),
                                          testing::Values(scene::Integrator::shi, scene::Integrator::trapezoidal,
                                                          scene::Integrator::generalized_alpha)),
                         name_of);

/// The trapezoidal rule damps nothing: what the start leaves of gaps within their tolerance rings on.
double tolerance() {
  return std::get<1>(Bonds::GetParam()) == scene::Integrator::trapezoidal ? 5e-4 : 1e-4;
}

TEST_P(Bonds, ABrittleBondAtTheHeelBreaksAtItsStrength) {
  for (int seed = 1; seed <= test::campaign(8); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const double width = random.between(0.5, 3);
    const double height = width * random.between(1.5, 5);
    const double weight = width * height * 2500 * g;
    const double share = random.between(0.005, 0.3);  // of the weight that the heel's bond holds
    const double load = width / height * (1 + 2 * share);
    scene::JointLaw law{.friction_angle_deg = random.between(30, 60)};
    law.residual_friction_angle_deg = law.friction_angle_deg;
    law.tension_strength_pa = share * weight / (width / 2);
    law.cohesion_pa = 4 * weight / width;
    const double found = load_at_failure(pushed_block(width, height, law, load));
    EXPECT_NEAR(found / load, 1, tolerance()) << "seed " << seed << ": " << width << " m by " << height << " m";
  }
}

TEST_P(Bonds, AJointWithCohesionAndPeakFrictionHoldsUpToBoth) {
  for (int seed = 1; seed <= test::campaign(4); ++seed) {
    test::Random random(static_cast<unsigned>(1000 + seed));
    const double height = random.between(0.5, 3);
    scene::JointLaw law{.friction_angle_deg = random.between(10, 30)};
    law.residual_friction_angle_deg = random.between(0.5, 1) * law.friction_angle_deg;
    const double cohesive = random.between(0.05, 0.3);  // of the weight
    law.softening_slip_m = seed % 2 == 0 ? 0.02 : 0;
    const double load = tangent(law.friction_angle_deg) + cohesive;
    const double width = height * load * random.between(1.1, 3);
    law.cohesion_pa = cohesive * height * 2500 * g;
    const double found = load_at_failure(pushed_block(width, height, law, load));
    EXPECT_NEAR(found / load, 1, tolerance()) << "seed " << seed << ": " << width << " m by " << height << " m";
  }
}

TEST_P(Bonds, AJointWithoutTensionStrengthOpensWhereTheHeelIsFree) {
  for (int seed = 1; seed <= test::campaign(4); ++seed) {
    test::Random random(static_cast<unsigned>(2000 + seed));
    const double width = random.between(0.5, 3);
    const double height = width * random.between(1.5, 5);
    const double load = width / height;
    scene::JointLaw law{.friction_angle_deg = 40, .residual_friction_angle_deg = random.between(20, 40)};
    law.cohesion_pa = height * 2500 * g;
    const double found = load_at_failure(pushed_block(width, height, law, load));
    EXPECT_NEAR(found / load, 1, tolerance()) << "seed " << seed << ": " << width << " m by " << height << " m";
  }
}

}  // namespace
}  // namespace blockweir::solid::bonds_test
