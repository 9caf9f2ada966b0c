// SPDX-License-Identifier: GPL-3.0-or-later
// Wall time against error: finds the runs that no other run beats.
#pragma once

#include <string>
#include <vector>

namespace blockweir::study {

/// A run of a bench.
struct Point {
  std::string curve;       ///< the setting that is varied
  std::string setting;     ///< "key=value"; empty: the scene itself
  double time_s = 0;       ///< shortest wall time of its repetitions
  double error = 0;        ///< relative, of the scene's first figure or of its motion
  double beside = 0;       ///< its wall time over that of the scene itself, run alternately; 0: not measured
  double energy_gain = 0;  ///< largest of its repetitions: energy produced, relative to the energy of the run
};

/// Errors below this are round-off and count as equal.
constexpr double round_off = 1e-12;

/// Whether `a` is faster than `b` with no larger error, or more accurate in no longer time, by more than a tenth.
bool betters(const Point& a, const Point& b);

/// The Pareto front: indices, sorted by time, of the points for which no other is faster and more accurate.
std::vector<std::size_t> front(const std::vector<Point>& points);

}  // namespace blockweir::study
