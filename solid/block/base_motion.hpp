// SPDX-License-Identifier: GPL-3.0-or-later
// Ground motion from its acceleration, integrated twice: exact for linear or stepwise rows and for a sine.
#pragma once

#include <array>
#include <vector>

#include "solid/block/block.hpp"

namespace blockweir::solid {

/// One axis; at time 0 at rest and as drawn.
class BaseAxis {
 public:
  BaseAxis() = default;
  explicit BaseAxis(const scene::TimeTable& acceleration);

  [[nodiscard]] double acceleration(const scene::TimeSpan& step) const { return acceleration_.at(step); }
  [[nodiscard]] double velocity(double time_s) const;
  [[nodiscard]] double displacement(double time_s) const;

 private:
  /// An interval in which the rows' acceleration is linear, with the state at its start.
  struct Stretch {
    double from_s = 0;
    double acceleration = 0;
    double slope = 0;
    double velocity = 0;
    double displacement = 0;
    [[nodiscard]] double velocity_at(double time_s) const;
    [[nodiscard]] double displacement_at(double time_s) const;
  };
  [[nodiscard]] const Stretch& stretch(double time_s) const;

  scene::TimeTable acceleration_ = scene::TimeTable::constant(0);
  std::vector<Stretch> stretches_;
};

/// Zero without a base motion in the scene.
class BaseMotion {
 public:
  explicit BaseMotion(const scene::Scene& scene);

  [[nodiscard]] Point acceleration(const scene::TimeSpan& step) const;
  /// Acceleration for the inertia force, zero if supports move instead [m/s2].
  [[nodiscard]] Point inertia(const scene::TimeSpan& step) const;
  /// Displacement of fixed blocks and supports, zero if an inertia force replaces it.
  [[nodiscard]] Point displacement(double time_s) const;
  [[nodiscard]] Point velocity(double time_s) const;
  [[nodiscard]] bool moves_supports() const { return moves_supports_; }
  [[nodiscard]] bool shakes() const { return shakes_; }
  /// Velocity of the ground itself, in either form: at the step's end, or its mean over the step [m/s].
  [[nodiscard]] Point ground_velocity(const scene::TimeSpan& step, bool mean) const;

 private:
  std::array<BaseAxis, 2> axes_;
  bool shakes_ = false;
  bool moves_supports_ = false;
};

}  // namespace blockweir::solid
