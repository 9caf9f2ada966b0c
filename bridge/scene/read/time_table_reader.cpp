// SPDX-License-Identifier: GPL-3.0-or-later
// The ways in which a scene states a quantity over time: constant, linear table, steps, ramp, sine. A table in a file
// has become one of the scene's own before (time_record.hpp).
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/read/table_reader.hpp"

namespace blockweir::scene {
namespace {

constexpr const char* forms =
    "a number, { table = [[time_s, value], ...] }, { steps = [[time_s, value], ...] }, "
    "{ from = value, rate_per_s = value }, { sine = amplitude, frequency_hz = value } or { file = \"record.csv\" }";

}  // namespace

bool TableReader::time_table(const char* key, std::optional<TimeTable>& into, double duration_s) {
  const toml::node* node = ask(key, false, forms);
  if (node == nullptr) return false;
  if (const auto value = finite_number(*node)) {
    into = TimeTable::constant(*value);
    return true;
  }
  const toml::table* described = node->as_table();
  if (described == nullptr) return wrong(key, *node, forms);
  TableReader inner(problems_, described, fmt::format("{} of {}", key, name_));
  TimeTable linear;
  TimeTable steps{.stepwise = true};
  TimeTable ramp;
  const bool linear_read = inner.rows("table", linear);
  const bool steps_read = inner.rows("steps", steps);
  const bool ramp_read = inner.ramp(ramp, duration_s);
  TimeTable wave;
  const bool wave_read = inner.wave(wave);
  if (inner.has("table") + inner.has("steps") + inner.has("from") + inner.has("sine") != 1) {
    problems_.error(inner.place(), fmt::format("{} does not state one course in time", inner.name()), forms,
                    "keep one of table, steps, from and sine");
    return false;
  }
  if (linear_read) into = std::move(linear);
  if (steps_read) into = std::move(steps);
  if (ramp_read) into = std::move(ramp);
  if (wave_read) into = std::move(wave);
  return linear_read || steps_read || ramp_read || wave_read;
}

bool TableReader::rows(const char* key, TimeTable& into) {
  const toml::node* node = ask(key, false, forms);
  if (node == nullptr) return false;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) return wrong(key, *node, "rows [[time_s, value], ...]");
  for (const auto& entry : *list) {
    const toml::array* row = entry.as_array();
    const bool pair = row != nullptr && row->size() == 2;
    const auto time = pair ? finite_number((*row)[0]) : std::nullopt;
    const auto value = pair ? finite_number((*row)[1]) : std::nullopt;
    if (!time || !value) return wrong(key, entry, "a row [time_s, value] of two finite numbers");
    if (!into.time_s.empty() && *time <= into.time_s.back()) {
      problems_.error(problems_.at(entry.source()),
                      fmt::format("{} in {} goes from time {} s to {} s", key, name_, into.time_s.back(), *time),
                      "times that increase from row to row", "put the rows in order and give each time once");
      return false;
    }
    into.time_s.push_back(*time);
    into.value.push_back(*value);
  }
  return true;
}

bool TableReader::ramp(TimeTable& into, double duration_s) {
  double from = 0;
  double rate = 0;
  std::optional<double> to;
  const bool starts = number("from", from);
  const bool rises = number("rate_per_s", rate, any_number(), has("from"));
  number("to", to);
  if (!starts || !rises) return false;
  const double end_s = to ? (*to - from) / rate : duration_s;
  const double end = to.value_or(from + rate * duration_s);
  if (!(end_s > 0) || !std::isfinite(end_s) || !std::isfinite(end)) {
    problems_.error(place("to"), fmt::format("{} never gets from {} to {} at {} per second", name_, from, end, rate),
                    "a ramp that leads towards its end", "turn the sign of rate_per_s, or leave \"to\" out");
    return false;
  }
  into = {.time_s = {0, end_s}, .value = {from, end}};
  return true;
}

bool TableReader::wave(TimeTable& into) {
  double mean = 0;
  double phase_deg = 0;
  double frequency_hz = 0;
  Sine sine;
  const bool swings = number("sine", sine.amplitude);
  const bool beats = number("frequency_hz", frequency_hz, positive(), has("sine"));
  number("phase_deg", phase_deg);
  number("mean", mean);
  if (!swings || !beats) return false;
  sine.angular_frequency = 2 * std::numbers::pi * frequency_hz;
  sine.phase = phase_deg * std::numbers::pi / 180;
  into = TimeTable::constant(mean);
  into.sine = sine;
  return true;
}

}  // namespace blockweir::scene
