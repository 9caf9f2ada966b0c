// SPDX-License-Identifier: GPL-3.0-or-later
// Weights of the Newmark family, by integrator.
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Over a step dt with accelerations a0, a1 at its ends: d = dt v0 + dt^2 ((1/2 - beta) a0 + beta a1), v1 = v0 +
/// dt ((1 - gamma) a0 + gamma a1), and balance (1 - alpha_f) F1 + alpha_f F0 = M ((1 - alpha_m) a1 + alpha_m a0).
struct NewmarkWeights {
  double beta = 0.5;  ///< Shi's scheme: 1/2, 1
  double gamma = 1;
  double alpha_m = 0;
  double alpha_f = 0;

  bool operator==(const NewmarkWeights&) const = default;
};

/// `spectral_radius`: of generalized-alpha (Chung and Hulbert 1993), 0 to 1.
inline NewmarkWeights newmark_weights(Integrator integrator, double spectral_radius) {
  if (integrator == Integrator::shi) return {};
  if (integrator == Integrator::trapezoidal) return {0.25, 0.5, 0, 0};
  const double am = (2 * spectral_radius - 1) / (spectral_radius + 1);
  const double af = spectral_radius / (spectral_radius + 1);
  return {(1 - am + af) * (1 - am + af) / 4, 0.5 - am + af, am, af};
}

}  // namespace blockweir::scene
