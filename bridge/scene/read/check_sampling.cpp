// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/check_sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blockweir::scene {
namespace {

constexpr double round_off = 1e-6;   // of the time between two looks
constexpr double negligible = 1e-3;  // of what a course goes through

void check_period(const std::string& name, const Place& place, const Sine& sine, const Sampling& sampling,
                  Problems& problems) {
  constexpr double least = 10;
  const double period_s = 2 * std::numbers::pi / sine.angular_frequency;
  if (period_s >= least * sampling.every_s * (1 - round_off)) return;
  problems.warning(place,
                   fmt::format("a period of {} takes {:.4g} s, {:.3g} times {}, {:.4g} s: its course is not followed",
                               name, period_s, period_s / sampling.every_s, sampling.key, sampling.every_s),
                   fmt::format("at least {:g} a period", least),
                   fmt::format("shorten {} to {:.2g} s", sampling.key, period_s / least));
}

}  // namespace

void check_sampling(const std::string& name, const Place& place, const TimeTable& course, const Sampling& sampling,
                    Problems& problems) {
  if (course.sine) check_period(name, place, *course.sine, sampling, problems);
  if (sampling.means) return;
  const auto [low, high] = std::minmax_element(course.value.begin(), course.value.end());
  const double seen = negligible * (*high - *low);
  for (std::size_t row = 0; row < course.time_s.size(); ++row) {
    const double time_s = course.time_s[row];
    if (time_s <= 0 || time_s >= sampling.duration_s) continue;
    const double before_s = std::floor(time_s / sampling.every_s + round_off) * sampling.every_s;
    const double after_s = std::min(before_s + sampling.every_s, sampling.duration_s);
    if (time_s - before_s <= round_off * sampling.every_s) continue;
    const auto [least, most] = std::minmax({course.rows_at(before_s), course.rows_at(after_s)});
    if (course.value[row] <= most + seen && course.value[row] >= least - seen) continue;
    problems.warning(place,
                     fmt::format("{} is {:.6g} at {:.6g} s, which the run does not see: it looks at {:.6g} s and "
                                 "{:.6g} s, where it is {:.6g} and {:.6g}",
                                 name, course.value[row], time_s, before_s, after_s, course.rows_at(before_s),
                                 course.rows_at(after_s)),
                     fmt::format("rows no closer than {}, {:.4g} s", sampling.key, sampling.every_s),
                     fmt::format("shorten {}", sampling.key));
    return;
  }
}

}  // namespace blockweir::scene
