// SPDX-License-Identifier: GPL-3.0-or-later
// Levels that no reservoir has: faster than a wave, or higher on the downstream side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/magnitudes.hpp"
#include "bridge/scene/outline.hpp"

namespace blockweir::scene {
namespace {

/// Times from 0 to the end at which a level may turn.
std::vector<double> corners(const TimeTable& level, double duration_s) {
  std::vector<double> times{0, duration_s};
  for (const double t : level.time_s) {
    if (t > 0 && t < duration_s) times.push_back(t);
  }
  std::sort(times.begin(), times.end());
  return times;
}

void check_rate(const char* key, const TimeTable& level, const toml::table& file, const Scene& scene, double bottom_m,
                Problems& problems) {
  if (level.stepwise) return;  // a step is meant to be sudden
  const std::vector<double> times = corners(level, scene.analysis.duration_s);
  const double gravity = scene.analysis.gravity_m_per_s2;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double from = level.rows_at(times[i - 1]);
    const double to = level.rows_at(times[i]);
    const double rate = std::abs(to - from) / (times[i] - times[i - 1]);
    const double wave = std::sqrt(gravity * std::max(0.0, std::max(from, to) - bottom_m));
    if (!(rate > wave)) continue;
    problems.warning(problems.at(file["water"][key].node()->source()),
                     fmt::format("{} goes from {} to {} m within {:.3g} s, which is unusual: {:.3g} m/s, faster than a "
                                 "wave in this water",
                                 key, from, to, times[i] - times[i - 1], rate),
                     fmt::format("up to {:.3g} m/s, the square root of g times its depth", wave),
                     "give it more time, or state { steps = [[time_s, value], ...] } for a sudden level");
    return;
  }
}

}  // namespace

void check_levels(const toml::table& file, const Scene& scene, Problems& problems) {
  if (scene.fluid == FluidModel::none || scene.analysis.gravity_m_per_s2 == 0) return;
  double bottom_m = std::numeric_limits<double>::infinity();
  for (const Block& block : scene.blocks) bottom_m = std::min(bottom_m, bounds_of(block.vertices).low.y());
  const auto& up = scene.water.upstream_level_m;
  const auto& down = scene.water.downstream_level_m;
  if (up) check_rate("upstream_level_m", *up, file, scene, bottom_m, problems);
  if (down) check_rate("downstream_level_m", *down, file, scene, bottom_m, problems);
  if (!up || !down) return;
  std::vector<double> times = corners(*up, scene.analysis.duration_s);
  for (const double t : corners(*down, scene.analysis.duration_s)) times.push_back(t);
  const auto above = std::find_if(times.begin(), times.end(), [&](double t) { return down->at(t) > up->at(t); });
  if (above == times.end()) return;
  problems.warning(problems.at(file["water"]["downstream_level_m"].node()->source()),
                   fmt::format("downstream_level_m is {} m at {} s and upstream_level_m {} m, which is unusual: the "
                               "tailwater is above the headwater",
                               down->at(*above), *above, up->at(*above)),
                   "a downstream level up to the upstream one", "are the two exchanged? x points downstream");
}

}  // namespace blockweir::scene
