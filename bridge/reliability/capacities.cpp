// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/capacities.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>

namespace blockweir::study {
namespace {

using nlohmann::json;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double tail = 0.025;

std::size_t count(const std::vector<double>& levels, const std::function<bool(double)>& holds) {
  return static_cast<std::size_t>(std::count_if(levels.begin(), levels.end(), holds));
}

Share independent(std::size_t with, std::size_t without_answer, std::size_t total) {
  using Trials = boost::math::binomial_distribution<>;
  const auto trials = static_cast<double>(total);
  const auto least = static_cast<double>(with);
  const auto most = static_cast<double>(with + without_answer);
  return {.value = least / trials,
          .from = Trials::find_lower_bound_on_p(trials, least, tail),
          .to = Trials::find_upper_bound_on_p(trials, most, tail)};
}

}  // namespace

double capacity_of(const Outcome& row) {
  const std::string outcome = row["outcome"];
  if (row.contains("trouble")) return std::nan("");
  if (outcome == "stands") return infinite;
  if (outcome == "does not stand empty") return -infinite;
  return outcome == "fails" && row["level_m"].is_number() ? row["level_m"].get<double>() : std::nan("");
}

Share Capacities::failing(double level_m) const {
  const auto fails = [level_m](double capacity) { return capacity <= level_m; };
  const std::size_t with = count(levels_m_, fails);
  const Share alone = independent(with, without_answer(), size());
  if (groups_ < 2) return alone;
  std::vector<double> shares;
  const auto each = static_cast<std::ptrdiff_t>(size() / groups_);
  for (auto from = levels_m_.begin(); from != levels_m_.end(); from += each) {
    shares.push_back(static_cast<double>(std::count_if(from, from + each, fails)) / static_cast<double>(each));
  }
  const double variance = boost::math::statistics::sample_variance(shares);
  if (variance == 0) return alone;
  const auto groups = static_cast<double>(groups_);
  const double quantile = boost::math::quantile(boost::math::students_t(groups - 1), 1 - tail);
  const double half = quantile * std::sqrt(variance / groups);
  const double in_doubt = static_cast<double>(without_answer()) / static_cast<double>(size());
  return {.value = alone.value,
          .from = std::max(0.0, alone.value - half),
          .to = std::min(1.0, alone.value + in_doubt + half)};
}

std::vector<double> Capacities::finite() const {
  std::vector<double> finite;
  std::copy_if(levels_m_.begin(), levels_m_.end(), std::back_inserter(finite),
               [](double level) { return std::isfinite(level); });
  std::sort(finite.begin(), finite.end());
  return finite;
}

std::pair<double, std::size_t> Capacities::commonest() const {
  constexpr double same = 1e-5;
  const std::vector<double> levels = finite();
  std::pair<double, std::size_t> best{levels.front(), 0};
  for (auto first = levels.begin(); first != levels.end(); ++first) {
    const auto last = std::upper_bound(first, levels.end(), *first + same * std::abs(*first));
    const auto count = static_cast<std::size_t>(last - first);
    if (count > best.second) best = {*(first + (last - first) / 2), count};
  }
  return best;
}

std::size_t Capacities::without_answer() const {
  return count(levels_m_, [](double level) { return std::isnan(level); });
}

std::size_t Capacities::that_stand() const {
  return count(levels_m_, [](double level) { return level == infinite; });
}

std::size_t Capacities::that_never_stand() const {
  return count(levels_m_, [](double level) { return level == -infinite; });
}

json Capacities::curve() const {
  constexpr int intervals = 100;
  const std::vector<double> levels = finite();
  json curve = json::array();
  for (int i = 0; i <= intervals && !levels.empty(); ++i) {
    const double level_m = levels.front() + (levels.back() - levels.front()) * i / intervals;
    const Share share = failing(level_m);
    curve.push_back({{"level_m", level_m}, {"probability", share.value}, {"from", share.from}, {"to", share.to}});
    if (levels.front() == levels.back()) break;
  }
  return curve;
}

double reliability_index(double probability) {
  if (probability <= 0) return infinite;
  if (probability >= 1) return -infinite;
  return -boost::math::quantile(boost::math::normal(), probability);
}

}  // namespace blockweir::study
