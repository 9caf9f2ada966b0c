// SPDX-License-Identifier: GPL-3.0-or-later
// The probability distribution of an uncertain number.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace blockweir::scene {

struct Distribution {
  std::string kind;                              ///< normal, lognormal, uniform, triangular, table or fitted
  double mean = 0;                               ///< normal and lognormal: mean of the variable itself
  double deviation = 0;                          ///< normal and lognormal: standard deviation of the variable itself
  double from = 0;                               ///< uniform and triangular
  double peak = 0;                               ///< triangular: the likeliest value
  double to = 0;                                 ///< uniform and triangular
  std::vector<std::pair<double, double>> table;  ///< pairs of a value and its cumulative probability; 0 first, 1 last
  std::vector<double> values;                    ///< fitted: the measured values
  std::optional<double> least;                   ///< the distribution is truncated below this value
  std::optional<double> most;
  bool operator==(const Distribution&) const = default;
};

}  // namespace blockweir::scene
