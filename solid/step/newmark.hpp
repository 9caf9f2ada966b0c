// SPDX-License-Identifier: GPL-3.0-or-later
// The Newmark family over one step, with the increment d as unknown.
#pragma once

#include "bridge/scene/newmark_weights.hpp"
#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// a1 = d/(beta dt^2) - v/(beta dt) - (1/(2 beta) - 1) a,  v1 = v + dt ((1 - gamma) a + gamma a1);
/// balance (1 - alpha_f) F1 + alpha_f F0 = M ((1 - alpha_m) a1 + alpha_m a0).
struct Newmark : scene::NewmarkWeights {
  bool damps = true;  ///< false if velocities are meaningless: quasi-static steps and the search for equilibrium

  bool operator==(const Newmark&) const = default;

  static Newmark of(scene::Integrator integrator, double spectral_radius) {
    return {scene::newmark_weights(integrator, spectral_radius)};
  }

  /// Factor of the mass in the step's matrix; the balance is divided by (1 - alpha_f).
  [[nodiscard]] double mass_factor(double dt) const { return (1 - alpha_m) / (1 - alpha_f) / (beta * dt * dt); }

  /// Viscous forces use the velocity velocity_factor d + past_velocity. It is v1, or, with Shi's scheme, the step's
  /// mean, since v1 may be opposite to d and a damper would then produce energy.
  [[nodiscard]] double velocity_factor(double dt) const {
    if (!damps) return 0;
    return second_order() ? gamma / (beta * dt) : 1 / dt;
  }
  [[nodiscard]] Vector6 past_velocity(const BlockState& s, double dt) const {
    if (!damps || !second_order()) return Vector6::Zero();
    return (1 - gamma / beta) * s.velocity + dt * (1 - 0.5 * gamma / beta) * s.acceleration;
  }

  /// Contribution of the past to the right-hand side, divided by (1 - alpha_f).
  template <class Inertia>  // inertia of a block, or a 6x6 matrix
  [[nodiscard]] Vector6 history(const Inertia& mass, const BlockState& s, double dt) const {
    const Vector6 a = (1 - alpha_m) * (s.velocity / (beta * dt) + (0.5 / beta - 1) * s.acceleration);
    return (alpha_f * s.force + mass * (a - alpha_m * s.acceleration)) / (1 - alpha_f);
  }

  /// Whether the scheme uses the forces at the start of the step. Shi's scheme does not: only the forces F1 at the end
  /// change the momentum, and the kinetic energy grows by F1 d, so an inelastic contact (F1 d <= 0) produces none.
  [[nodiscard]] bool second_order() const { return gamma != 1 || beta != 0.5; }

  /// Part in M a1 of a force that grows from `before` to `now` and had this part in M a0.
  [[nodiscard]] Point inertial(const Point& before, const Point& now, const Point& in_a0) const {
    return ((1 - alpha_f) * now + alpha_f * before - alpha_m * in_a0) / (1 - alpha_m);
  }
  /// Its impulse in the step, over dt, from its parts in M a0 and M a1.
  [[nodiscard]] Point through_step(const Point& in_a0, const Point& in_a1) const {
    return (1 - gamma) * in_a0 + gamma * in_a1;
  }

  /// Velocity and acceleration at the end of a step with increment d.
  void finish(BlockState& s, const Vector6& d, double dt) const {
    const Vector6 a1 = (d / dt - s.velocity) / (beta * dt) - (0.5 / beta - 1) * s.acceleration;
    s.velocity += dt * ((1 - gamma) * s.acceleration + gamma * a1);
    s.acceleration = a1;
  }
};

}  // namespace blockweir::solid
