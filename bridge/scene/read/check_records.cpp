// SPDX-License-Identifier: GPL-3.0-or-later
// Records that are far longer than the run: their times may be in another unit.
#include <fmt/format.h>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

void check_records(Reading& reading) {
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

}  // namespace blockweir::scene
