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
