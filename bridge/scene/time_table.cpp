// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/time_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::scene {

TimeTable TimeTable::constant(double value) {
  return {.time_s = {0}, .value = {value}};
}

double TimeTable::at(double time) const {
  if (!sine) return rows_at(time);
  return rows_at(time) + sine->amplitude * std::sin(sine->angular_frequency * time + sine->phase);
}

double TimeTable::at(const TimeSpan& step) const {
  constexpr double round_off = 1e-6;  // of the step: a row so near to its end is at its end
  const double margin = round_off * (step.to_s - step.from_s);
  const auto first = std::upper_bound(time_s.begin(), time_s.end(), step.from_s + margin);
  const auto last = std::lower_bound(first, time_s.end(), step.to_s - margin);
  if (first == last) return at(step.to_s);
  double sum = 0;
  double from = step.from_s;
  const auto add_until = [&](double to) {  // linear, or constant, from row to row
    sum += (to - from) * rows_at((from + to) / 2);
    from = to;
  };
  std::for_each(first, last, add_until);
  add_until(step.to_s);
  return sum / (step.to_s - step.from_s) + at(step.to_s) - rows_at(step.to_s);
}

double TimeTable::constant_until(double time) const {
  if (sine) return time;
  const double now = rows_at(time);
  double until = time;
  for (std::size_t row = 0; row < time_s.size(); ++row) {
    if (time_s[row] <= time) continue;
    if (!stepwise && value[row] != now) return until;
    until = time_s[row];
    if (value[row] != now) return until;
  }
  return value.back() == now ? std::numeric_limits<double>::infinity() : until;
}

std::vector<double> TimeTable::hidden_between(double from_s, double to_s) const {
  constexpr double negligible = 1e-3;
  constexpr double round_off = 1e-6;
  const double margin = round_off * (to_s - from_s);
  const auto first = std::upper_bound(time_s.begin(), time_s.end(), from_s + margin);
  const auto last = std::lower_bound(first, time_s.end(), to_s - margin);
  if (first == last) return {};
  const auto [low, high] = std::minmax_element(value.begin() + (first - time_s.begin()),  // of the rows between
                                               value.begin() + (last - time_s.begin()));
  const auto [least, most] = std::minmax({rows_at(from_s), rows_at(to_s)});
  const double hidden = std::max(*high - most, least - *low);
  if (hidden <= 0) return {};
  const auto [lowest, highest] = std::minmax_element(value.begin(), value.end());
  if (hidden <= negligible * (*highest - *lowest)) return {};
  return {first, last};
}

double TimeTable::rows_at(double time) const {
  if (time <= time_s.front()) return value.front();
  if (time >= time_s.back()) return value.back();
  const auto after = static_cast<std::size_t>(std::upper_bound(time_s.begin(), time_s.end(), time) - time_s.begin());
  const std::size_t before = after - 1;
  if (stepwise) return value[before];
  const double fraction = (time - time_s[before]) / (time_s[after] - time_s[before]);
  return value[before] + fraction * (value[after] - value[before]);
}

}  // namespace blockweir::scene
