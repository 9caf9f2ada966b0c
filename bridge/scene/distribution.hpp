// SPDX-License-Identifier: GPL-3.0-or-later
// How likely the values of a number are that is not known.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace blockweir::scene {

struct Distribution {
  std::string kind;                              ///< normal, lognormal, uniform, triangular, table or fitted
  double mean = 0;                               ///< normal and lognormal: of the variable itself
  double deviation = 0;                          ///< the same: standard deviation
  double from = 0;                               ///< uniform and triangular
  double peak = 0;                               ///< triangular: the likeliest value
  double to = 0;                                 ///< uniform and triangular
  std::vector<std::pair<double, double>> table;  ///< a value, and the probability of less than it; 0 first, 1 last
  std::vector<double> values;                    ///< fitted: what was measured
  std::optional<double> least;                   ///< it is cut off there
  std::optional<double> most;
  bool operator==(const Distribution&) const = default;
};

}  // namespace blockweir::scene
