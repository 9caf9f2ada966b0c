// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/time_table.hpp"

#include <algorithm>

namespace blockweir::scene {

TimeTable TimeTable::constant(double value) {
  return {.time_s = {0}, .value = {value}};
}

double TimeTable::at(double time) const {
  if (time <= time_s.front()) return value.front();
  if (time >= time_s.back()) return value.back();
  const auto after = static_cast<std::size_t>(std::upper_bound(time_s.begin(), time_s.end(), time) - time_s.begin());
  const std::size_t before = after - 1;
  if (stepwise) return value[before];
  const double fraction = (time - time_s[before]) / (time_s[after] - time_s[before]);
  return value[before] + fraction * (value[after] - value[before]);
}

double TimeTable::largest() const {
  return *std::max_element(value.begin(), value.end());
}

double TimeTable::smallest() const {
  return *std::min_element(value.begin(), value.end());
}

}  // namespace blockweir::scene
