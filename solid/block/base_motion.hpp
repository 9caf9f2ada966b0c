// SPDX-License-Identifier: GPL-3.0-or-later
// The ground's motion from its acceleration, integrated twice: exact for rows, linear or stepwise, and for a sine.
#pragma once

#include <array>
#include <vector>

#include "solid/block/block.hpp"

namespace blockweir::solid {

/// One axis, at rest where the scene draws it at time 0.
class BaseAxis {
 public:
  BaseAxis() = default;
  explicit BaseAxis(const scene::TimeTable& acceleration);

  [[nodiscard]] double acceleration(const scene::TimeSpan& step) const { return acceleration_.at(step); }
  [[nodiscard]] double velocity(double time_s) const;
  [[nodiscard]] double displacement(double time_s) const;

 private:
  /// A stretch of time over which the rows' acceleration is linear, with the state at its start.
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

/// Nothing moves where the scene has no base motion.
class BaseMotion {
 public:
  explicit BaseMotion(const scene::Scene& scene);

  [[nodiscard]] Point acceleration(const scene::TimeSpan& step) const;
  /// Of the inertia force's frame, zero where supports move instead [m/s2].
  [[nodiscard]] Point inertia(const scene::TimeSpan& step) const;
  /// Of fixed blocks and held points, zero where an inertia force stands for their motion.
  [[nodiscard]] Point displacement(double time_s) const;
  [[nodiscard]] Point velocity(double time_s) const;
  [[nodiscard]] bool moves_supports() const { return moves_supports_; }
  [[nodiscard]] bool shakes() const { return shakes_; }
  /// Of the ground itself, in whichever form it acts: at the step's end, or its mean over the step [m/s].
  [[nodiscard]] Point ground_velocity(const scene::TimeSpan& step, bool mean) const;

 private:
  std::array<BaseAxis, 2> axes_;
  bool shakes_ = false;
  bool moves_supports_ = false;
};

}  // namespace blockweir::solid
