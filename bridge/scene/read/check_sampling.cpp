// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/check_sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blockweir::scene {
namespace {

constexpr double round_off = 1e-6;  // of the time between two looks

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
  if (sampling.rows_are_seen) return;
  for (const double row_s : course.time_s) {
    if (row_s <= 0 || row_s >= sampling.duration_s) continue;
    const double before_s = std::floor(row_s / sampling.every_s + round_off) * sampling.every_s;
    const double after_s = std::min(before_s + sampling.every_s, sampling.duration_s);
    const std::vector<double> hidden = course.hidden_between(before_s, after_s);
    if (hidden.empty()) continue;
    const double seen = (course.rows_at(before_s) + course.rows_at(after_s)) / 2;
    const double farthest_s = *std::max_element(hidden.begin(), hidden.end(), [&](double a, double b) {
      return std::abs(course.rows_at(a) - seen) < std::abs(course.rows_at(b) - seen);
    });
    problems.error(place,
                   fmt::format("{} is {:.6g} at {:.6g} s, which the run does not read: it reads at {:.6g} s and "
                               "{:.6g} s, where it is {:.6g} and {:.6g}",
                               name, course.rows_at(farthest_s), farthest_s, before_s, after_s,
                               course.rows_at(before_s), course.rows_at(after_s)),
                   fmt::format("rows no closer than {}, {:.4g} s", sampling.key, sampling.every_s),
                   fmt::format("shorten {}", sampling.key));
    return;
  }
}

}  // namespace blockweir::scene
