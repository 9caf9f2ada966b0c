// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity that a scene states over time: constant, ramp, steps or table.
#pragma once

#include <vector>

namespace blockweir::scene {

/// Piecewise function of time, held constant before the first and after the last row.
/// Linear between rows, or stepwise: a row's value then holds until the next row's time.
struct TimeTable {
  std::vector<double> time_s;  ///< strictly increasing, at least one row
  std::vector<double> value;   ///< same length; unit as the owner's name says
  bool stepwise = false;

  static TimeTable constant(double value);

  [[nodiscard]] double at(double time_s) const;
  [[nodiscard]] double largest() const;
  [[nodiscard]] double smallest() const;
  bool operator==(const TimeTable&) const = default;
};

}  // namespace blockweir::scene
