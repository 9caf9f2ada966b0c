// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/distribution_quantile.hpp"

#include <algorithm>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <cmath>
#include <limits>

namespace blockweir::study {
namespace {

using scene::Distribution;

/// Between `least` and `most`, where the distribution is cut off.
template <class Known>
double quantile_of_cut(const Known& known, const Distribution& d, double probability) {
  constexpr double tiny = std::numeric_limits<double>::epsilon();
  const auto [first, last] = boost::math::support(known);
  const double from = d.least && *d.least > first ? boost::math::cdf(known, *d.least) : 0;
  const double to = d.most && *d.most < last ? boost::math::cdf(known, *d.most) : 1;
  const double value = boost::math::quantile(known, std::clamp(from + probability * (to - from), tiny, 1 - tiny));
  return std::clamp(value, d.least.value_or(-std::numeric_limits<double>::max()),
                    d.most.value_or(std::numeric_limits<double>::max()));
}

double quantile_of_table(const Distribution& d, double probability) {
  const auto& rows = d.table;
  const auto after = std::find_if(rows.begin() + 1, rows.end() - 1,
                                  [probability](const auto& row) { return row.second >= probability; });
  const auto& [value, less] = *(after - 1);
  return value + (after->first - value) * (probability - less) / (after->second - less);
}

double quantile_of_values(std::vector<double> values, double probability) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(probability * static_cast<double>(values.size()))];
}

}  // namespace

double quantile_of(const Distribution& d, double probability) {
  const auto cut = [&](const auto& known) { return quantile_of_cut(known, d, probability); };
  if (d.kind == "normal") return cut(boost::math::normal(d.mean, d.deviation));
  if (d.kind == "lognormal") {
    const double variance = std::log1p(std::pow(d.deviation / d.mean, 2));  // of its logarithm
    return cut(boost::math::lognormal(std::log(d.mean) - variance / 2, std::sqrt(variance)));
  }
  if (d.kind == "uniform") return cut(boost::math::uniform(d.from, d.to));
  if (d.kind == "triangular") return cut(boost::math::triangular(d.from, d.peak, d.to));
  const double value =
      d.kind == "table" ? quantile_of_table(d, probability) : quantile_of_values(d.values, probability);
  return std::clamp(value, d.least.value_or(value), d.most.value_or(value));
}

}  // namespace blockweir::study
