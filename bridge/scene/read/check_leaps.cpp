// SPDX-License-Identifier: GPL-3.0-or-later
// Supports that leap: a block cannot follow a jump, and a run stops there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/place_text.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

struct Leap {
  double at_s = 0;
  double way_m = 0;
};

/// The longest way within a step; it begins with the step.
Leap longest_in_a_step(const TimeTable& course, const Analysis& analysis) {
  constexpr double looks = 2e5;  // at most, of long runs
  const double step_s = analysis.step_s;
  const double apart_s = std::max(step_s, analysis.duration_s / looks);
  Leap longest;
  const auto look = [&](double from_s) {
    if (from_s < 0 || from_s >= analysis.duration_s) return;
    const double way_m = std::abs(course.at(std::min(from_s + step_s, analysis.duration_s)) - course.at(from_s));
    if (way_m > longest.way_m) longest = {from_s, way_m};
  };
  for (double from_s = 0; course.sine && from_s < analysis.duration_s; from_s += apart_s) look(from_s);
  for (const double row_s : course.time_s) look(row_s);
  return longest;
}

/// Of a course that jumps from row to row.
Leap longest_jump(const TimeTable& course, const Analysis& analysis) {
  Leap longest;
  for (std::size_t i = 1; course.stepwise && i < course.value.size(); ++i) {
    const double way_m = std::abs(course.value[i] - course.value[i - 1]);
    const bool in_run = course.time_s[i] > 0 && course.time_s[i] <= analysis.duration_s;
    if (in_run && way_m > longest.way_m) longest = {course.time_s[i], way_m};
  }
  return longest;
}

void check_leap(const Reading& reading, const Place& place, const char* key, const TimeTable& course,
                const Support& support) {
  const Analysis& analysis = reading.scene.analysis;
  const Block& block = reading.scene.blocks[at(support.block)];
  const double size_m = structure_size_m(reading.scene.blocks);
  const std::string name = fmt::format("{} in [[support]]", key);
  const std::string whose =
      fmt::format(", of block \"{}\" at {} m", block.name, geometry::place_text(support.point_m, size_m));
  const double begins_m = course.at(0);
  if (std::abs(begins_m) > 1e-6 * geometry::bounds_of(block.vertices).size()) {
    reading.problems.warning(place,
                             fmt::format("{} is {:.4g} m at time 0: the point leaps there{}", name, begins_m, whose),
                             "0 at time 0, as the blocks are drawn",
                             fmt::format("write {} = {{ from = 0, rate_per_s = ..., to = {:.4g} }}", key, begins_m));
  }
  if (const Leap jump = longest_jump(course, analysis); jump.way_m > analysis.failure_displacement_m) {
    reading.problems.warning(
        place,
        fmt::format("{} leaps by {:.4g} m at {:.4g} s: no block follows a jump, and the run stops there{}", name,
                    jump.way_m, jump.at_s, whose),
        fmt::format("jumps of at most failure_displacement_m, {:.3g} m", analysis.failure_displacement_m),
        "write { table = [[time_s, value], ...] }, which is linear between rows");
    return;
  }
  if (course.stepwise) return;
  const Leap fast = longest_in_a_step(course, analysis);
  const double most_m = analysis.max_displacement_ratio * size_m / 2;
  if (fast.way_m <= most_m) return;
  reading.problems.warning(
      place,
      fmt::format("{} goes {:.4g} m from {:.4g} s on within step_s, {:.4g} s, which is unusual: {:.3g} m/s{}", name,
                  fast.way_m, fast.at_s, analysis.step_s, fast.way_m / analysis.step_s, whose),
      fmt::format("up to {:.3g} m, what max_displacement_ratio lets a block move in a step", most_m),
      "write values that are in mm as m, times in s, or shorten step_s");
}

}  // namespace

void check_leaps(const Reading& reading) {
  const Scene& scene = reading.scene;
  const toml::array* stated = reading.file["support"].as_array();
  if (stated == nullptr || scene.analysis.kind == AnalysisKind::at_rest) return;  // statics leads them there
  for (std::size_t i = 0; i < scene.supports.size() && i < stated->size(); ++i) {
    const Support& support = scene.supports[i];
    for (const auto& [key, course] : {std::pair("displacement_x_m", &support.displacement_x_m),
                                      std::pair("displacement_y_m", &support.displacement_y_m)}) {
      const toml::table* table = (*stated)[i].as_table();
      const toml::node* node = table == nullptr ? nullptr : table->get(key);
      if (*course && node != nullptr) check_leap(reading, reading.problems.at(node->source()), key, **course, support);
    }
  }
}

}  // namespace blockweir::scene
