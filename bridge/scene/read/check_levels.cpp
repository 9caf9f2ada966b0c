// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of levels that no reservoir has (faster than a wave, or higher downstream), and of those that a run does not
// reach or see.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/check_sampling.hpp"
#include "bridge/scene/read/magnitudes.hpp"

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

/// A level that a table or ramp would come to after the run's end.
void check_end(const char* key, const TimeTable& level, const toml::table& file, const Scene& scene,
               Problems& problems) {
  const double duration_s = scene.analysis.duration_s;
  const auto [lowest, highest] = std::minmax_element(level.value.begin(), level.value.end());
  double low = std::min(level.rows_at(0), level.rows_at(duration_s));
  double high = std::max(level.rows_at(0), level.rows_at(duration_s));
  for (const double t : corners(level, duration_s)) {
    low = std::min(low, level.rows_at(t));
    high = std::max(high, level.rows_at(t));
  }
  if (*lowest >= low && *highest <= high) return;
  const auto missed = *highest > high ? highest : lowest;
  const double time_s = level.time_s[static_cast<std::size_t>(missed - level.value.begin())];
  problems.warning(
      problems.at(file["water"][key].node()->source()),
      fmt::format("{} never reaches its {:.6g} m at {:.6g} s: the run {}", key, *missed, time_s,
                  time_s > 0 ? fmt::format("ends after {} s, at {:.6g} m", duration_s, level.rows_at(duration_s))
                             : "begins at 0 s"),
      "levels within the run", "lengthen duration_s, or raise the level faster");
}

constexpr double level_accuracy = 1e-3;  // of the water's depth

/// A sine whose crests lie between two looks.
void check_crests(const std::string& name, const Place& place, const TimeTable& level, const Sampling& sampling,
                  double depth_m, Problems& problems) {
  if (!level.sine) return;
  const double period_s = 2 * std::numbers::pi / level.sine->angular_frequency;
  const double looks_a_period = std::max(1.0, period_s / sampling.every_s);
  const double unseen_m = std::abs(level.sine->amplitude) * (1 - std::cos(std::numbers::pi / looks_a_period));
  if (unseen_m <= level_accuracy * depth_m) return;
  const double most_s = period_s / std::numbers::pi *
                        std::acos(std::max(-1.0, 1 - level_accuracy * depth_m / std::abs(level.sine->amplitude)));
  problems.error(place,
                 fmt::format("the crests of {} are up to {:.3g} m above the values that the run reads: it reads every "
                             "{:.4g} s, and the period is {:.4g} s",
                             name, unseen_m, sampling.every_s, period_s),
                 fmt::format("up to {:.3g} m, a thousandth of the water's depth", level_accuracy * depth_m),
                 fmt::format("shorten {} to {:.2g} s", sampling.key, most_s));
}

/// Still water has the level that a window begins with. Windows are cut where the level of serial and parallel
/// schedules peaks: bridge/schedule/windows.hpp.
void check_windows(const char* key, const TimeTable& level, const toml::table& file, const Scene& scene,
                   double bottom_m, Problems& problems) {
  if (scene.analysis.kind == AnalysisKind::at_rest) return;
  const Coupling& coupling = scene.coupling;
  const bool openfoam = scene.fluid == FluidModel::openfoam;
  const bool grow = coupling.longest_window_s > coupling.window_s;
  const double longest_s = grow ? coupling.longest_window_s : coupling.window_s;
  const Sampling looks{grow ? "[coupling] longest_window_s" : "[coupling] window_s",
                       openfoam ? longest_s / scene.openfoam.steps_per_window : longest_s, scene.analysis.duration_s,
                       !openfoam && coupling.schedule != Schedule::improved};
  const std::string name = std::string(key) + " in [water]";
  const Place place = problems.at(file["water"][key].node()->source());
  const double depth_m = *std::max_element(level.value.begin(), level.value.end()) - bottom_m;
  check_sampling(name, place, level, looks, problems);
  check_crests(name, place, level, looks, depth_m, problems);
}

/// Laws of uplift tell a crack's ends apart by the pools: of an upright joint, which has a pool on one side alone, the
/// upstream end is taken for the one that the upstream pool would wet.
void check_lone_tailwater(const toml::table& file, const Scene& scene, Problems& problems) {
  const auto tells_ends_apart = [](const JointLaw& law) { return law.uplift != Uplift::none && !law.has_flow(); };
  const bool any = tells_ends_apart(scene.default_joint) ||
                   std::any_of(scene.joints.begin(), scene.joints.end(),
                               [&](const auto& joint) { return tells_ends_apart(joint.law); });
  if (!any) return;
  problems.warning(problems.at(file["water"]["downstream_level_m"].node()->source()),
                   "there is a downstream pool and no upstream one, which is unusual with uplift: where a joint's end "
                   "is dry, its pressure is that of the other pool, here none",
                   "the pool that presses on the structure upstream, where x is small",
                   "mirror the scene and state upstream_level_m, or uplift = \"flow\"");
}

}  // namespace

void check_levels(const toml::table& file, const Scene& scene, Problems& problems) {
  if (scene.fluid == FluidModel::none || scene.analysis.gravity_m_per_s2 == 0) return;
  double bottom_m = std::numeric_limits<double>::infinity();
  for (const Block& block : scene.blocks) bottom_m = std::min(bottom_m, geometry::bounds_of(block.vertices).low.y());
  const auto& up = scene.water.upstream_level_m;
  const auto& down = scene.water.downstream_level_m;
  for (const auto& [key, level] : {std::pair{"upstream_level_m", &up}, {"downstream_level_m", &down}}) {
    if (!*level) continue;
    check_rate(key, **level, file, scene, bottom_m, problems);
    const bool follows_table =
        scene.fluid == FluidModel::openfoam && scene.openfoam.level_control == LevelControl::table;
    if (still_pools(scene.fluid) || follows_table) {
      check_windows(key, **level, file, scene, bottom_m, problems);
    }
    // OpenFOAM's mesh is as high as the table, whenever it comes there.
    if (still_pools(scene.fluid)) check_end(key, **level, file, scene, problems);
  }
  if (!up && down && still_pools(scene.fluid)) check_lone_tailwater(file, scene, problems);
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
