// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity that a scene states over time: constant, ramp, steps, table or sine.
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

/// Of a step; an instant is one, too.
struct TimeSpan {
  TimeSpan(double instant_s) : from_s(instant_s), to_s(instant_s) {}
  TimeSpan(double from, double to) : from_s(from), to_s(to) {}
  double from_s;
  double to_s;
};

/// Piecewise function of time, held constant before the first and after the last row; a sine may go on top of it.
/// Linear between rows, or stepwise: a row's value then holds until the next row's time.
struct TimeTable {
  std::vector<double> time_s;  ///< strictly increasing, at least one row
  std::vector<double> value;   ///< same length; unit as the owner's name says
  bool stepwise = false;
  std::optional<Sine> sine{};

  static TimeTable constant(double value);

  [[nodiscard]] double at(double time_s) const;
  /// What acts in a step: the value at its end, or the rows' mean over it where some lie within, so that what comes and
  /// goes between two steps' ends keeps its impulse.
  [[nodiscard]] double at(const TimeSpan& step) const;
  /// The value stays what it is at `time_s` at all later times before this one; `time_s` itself where it changes.
  [[nodiscard]] double constant_until(double time_s) const;
  [[nodiscard]] double rows_at(double time_s) const;  ///< without the sine
  /// Times of the rows between two looks where one of them is higher or lower than what both looks see, by more than a
  /// thousandth of what all rows go through; none else.
  [[nodiscard]] std::vector<double> hidden_between(double from_s, double to_s) const;
  bool operator==(const TimeTable&) const = default;
};

}  // namespace blockweir::scene
