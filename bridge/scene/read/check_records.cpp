// SPDX-License-Identifier: GPL-3.0-or-later
// Records whose times or accelerations may be in another unit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// Far longer than the run: their times may be in ms.
void check_lengths(const Reading& reading) {
  constexpr double far_longer = 100;
  const double end_s = reading.scene.analysis.duration_s;
  for (const auto& [described, source] : reading.records) {
    const toml::array* rows = (*described->as_table())["table"].as_array();
    const double last_s = (*rows->back().as_array())[0].value_or(0.0);
    if (!(last_s > far_longer * end_s)) continue;
    reading.problems.warning(
        reading.problems.at(described->source()),
        fmt::format("the record {} ends at {:.6g} s, {:.3g} times the {:.6g} s of the run, of which it gives the "
                    "beginning alone",
                    source.file, last_s, last_s / end_s, end_s),
        "times in s", "write times that are in ms as s, or lengthen duration_s");
  }
}

/// What to do about accelerations that are too large; a stated scale may be what makes them so.
std::string scale_advice(const Reading& reading, const toml::node* described) {
  const auto source = reading.records.find(described);
  if (source == reading.records.end() || !source->second.scale)
    return "981 is cm/s2: give scale = 0.01 beside the record";
  return fmt::format(
      "the rows of {} are multiplied by scale = {:g}: take it out where they are in m/s2, and give 0.01 where they are "
      "in cm/s2",
      source->second.file, *source->second.scale);
}

void check_accelerations(const Reading& reading) {
  constexpr double most = 30;  // m/s2, three times gravity
  const std::optional<BaseMotion>& motion = reading.scene.base_motion;
  if (!motion) return;
  for (const auto& [key, table] : {std::pair{"acceleration_x_m_per_s2", &motion->acceleration_x_m_per_s2},
                                   {"acceleration_y_m_per_s2", &motion->acceleration_y_m_per_s2}}) {
    double largest = table->sine ? std::abs(table->sine->amplitude) : 0;
    for (const double value : table->value) largest = std::max(largest, std::abs(value));
    if (largest <= most) continue;
    const toml::node* node = reading.file["base_motion"][key].node();
    reading.problems.warning(reading.problems.at(node->source()),
                             fmt::format("{} in [base_motion] reaches {:.4g} m/s2, which is unusual", key, largest),
                             fmt::format("up to {} m/s2", most), scale_advice(reading, node));
  }
}

}  // namespace

void check_records(const Reading& reading) {
  check_lengths(reading);
  check_accelerations(reading);
}

}  // namespace blockweir::scene
