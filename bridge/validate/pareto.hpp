// SPDX-License-Identifier: GPL-3.0-or-later
// Wall time against error: which of many runs nobody betters.
#pragma once

#include <string>
#include <vector>

namespace blockweir::study {

/// A run of a bench.
struct Point {
  std::string curve;       ///< the setting that it belongs to
  std::string setting;     ///< "key=value"; empty: the scene as it stands
  double time_s = 0;       ///< least wall time of its repeats
  double error = 0;        ///< relative, of the scene's first figure or of its motion
  double beside = 0;       ///< its wall time over the scene's as it stands, run by turns with it alone; 0: was not
  double energy_gain = 0;  ///< largest of its repeats: energy made, of what the run had
};

/// Errors below it are round-off, and equal.
constexpr double round_off = 1e-12;

/// Is `a` faster than `b` at no larger error, or more accurate at no longer time, by more than a tenth?
bool betters(const Point& a, const Point& b);

/// Indices of those that no other is both faster and more accurate than, by time: the Pareto front.
std::vector<std::size_t> front(const std::vector<Point>& points);

}  // namespace blockweir::study
