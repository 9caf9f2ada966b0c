// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/static_strength.hpp"

#include <cmath>
#include <numbers>

#include "solid/static_blocks.hpp"

namespace blockweir::solid {

scene::Scene with_reduced_strength(scene::Scene scene, double reduction) {
  const auto reduce = [reduction](scene::JointLaw& law) {
    for (double* angle_deg : {&law.friction_angle_deg, &law.residual_friction_angle_deg}) {
      constexpr double degree = std::numbers::pi / 180;
      *angle_deg = std::atan(std::tan(*angle_deg * degree) / reduction) / degree;
    }
    law.cohesion_pa /= reduction;
  };
  reduce(scene.default_joint);
  for (scene::Joint& joint : scene.joints) reduce(joint.law);
  return scene;
}

StaticStrength static_strength(const scene::Scene& scene, StillWater* water, double level_m, double guess) {
  constexpr double exact = 1e-9;   // width of the bracket at the end
  constexpr double largest = 1e6;  // a factor beyond is none
  const auto stands = [&](double reduction) {
    const scene::Scene reduced = with_reduced_strength(scene, reduction);
    try {
      return StaticBlocks(reduced, water).begin(level_m);
    } catch (const SolveError&) {
      return false;  // it has no equilibrium under its first loads
    }
  };
  double stands_at = guess;
  double fails_at = guess;
  // The bracket grows from the guess on until it has both.
  const bool first = stands(guess);
  for (double step = 10 * exact;; step *= 10) {
    double& end = first ? fails_at : stands_at;
    end = first ? end * (1 + step) : end / (1 + step);
    if (end > largest) return {.bearing = limit::Bearing::bears_any};
    if (end < 1 / largest) return {.bearing = limit::Bearing::bears_none};
    if (stands(end) != first) break;
    (first ? stands_at : fails_at) = end;
  }
  while (fails_at - stands_at > exact * stands_at) {
    const double middle = (stands_at + fails_at) / 2;
    (stands(middle) ? stands_at : fails_at) = middle;
  }
  return {.bearing = limit::Bearing::fails_at_a_factor,
          .factor = (stands_at + fails_at) / 2,
          .width = fails_at - stands_at};
}

}  // namespace blockweir::solid
