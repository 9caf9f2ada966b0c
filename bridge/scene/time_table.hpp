// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity over time: constant, ramp, steps, table or sine.
#pragma once

#include <optional>
#include <vector>

namespace blockweir::scene {

/// amplitude sin(2 pi f t + phase)
struct Sine {
  double amplitude = 0;
  double angular_frequency = 0;  ///< rad/s
  double phase = 0;              ///< rad
  bool operator==(const Sine&) const = default;
};

/// A time step; an instant is a step of zero length.
struct TimeSpan {
  TimeSpan(double instant_s) : from_s(instant_s), to_s(instant_s) {}
  TimeSpan(double from, double to) : from_s(from), to_s(to) {}
  double from_s;
  double to_s;
};

/// Piecewise function of time, constant before the first and after the last row; a sine may be added to it. Linear
/// between rows, or stepwise: each value holds until the next row's time.
struct TimeTable {
  std::vector<double> time_s;  ///< strictly increasing, at least one row
  std::vector<double> value;   ///< same length; unit as in the owner's name
  bool stepwise = false;
  std::optional<Sine> sine{};

  static TimeTable constant(double value);

  [[nodiscard]] double at(double time_s) const;
  /// The value that acts in a step: that at its end, or the mean of the rows over the step if some lie within it. Short
  /// peaks between the ends of two steps thus keep their impulse.
  [[nodiscard]] double at(const TimeSpan& step) const;
  /// The time until which the value stays as it is at `time_s`; `time_s` itself if it changes.
  [[nodiscard]] double constant_until(double time_s) const;
  [[nodiscard]] double rows_at(double time_s) const;  ///< without the sine
  /// Times of rows between two evaluations that are higher or lower than both evaluated values by more than a
  /// thousandth of the table's range. Empty if there are none.
  [[nodiscard]] std::vector<double> hidden_between(double from_s, double to_s) const;
  bool operator==(const TimeTable&) const = default;
};

}  // namespace blockweir::scene
