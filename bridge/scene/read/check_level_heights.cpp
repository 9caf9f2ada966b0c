// SPDX-License-Identifier: GPL-3.0-or-later
// Levels beside the structures that are to retain the water.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/reading.hpp"
#include "bridge/scene/standing_groups.hpp"

namespace blockweir::scene {
namespace {

/// Lowest and highest value that a table takes from time 0 to `duration_s`.
std::pair<double, double> extremes(const TimeTable& table, double duration_s) {
  auto [low, high] = std::minmax({table.rows_at(0), table.rows_at(duration_s)});
  for (std::size_t i = 0; i < table.time_s.size(); ++i) {
    if (table.time_s[i] < 0 || table.time_s[i] > duration_s) continue;
    low = std::min(low, table.value[i]);
    high = std::max(high, table.value[i]);
  }
  if (table.sine) low -= std::abs(table.sine->amplitude), high += std::abs(table.sine->amplitude);
  return {low, high};
}

/// Crest: the top of what can move and stands on the ground, or the highest vertex if nothing moves. Bottom: the
/// lowest.
struct Heights {
  double bottom_m;
  double crest_m;
  StandingGroups groups;
};

Heights heights_of(const std::vector<Block>& blocks) {
  double bottom_m = std::numeric_limits<double>::infinity();
  double top_m = -bottom_m;
  for (const Block& block : blocks) {
    const geometry::Bounds box = geometry::bounds_of(block.vertices);
    bottom_m = std::min(bottom_m, box.low.y());
    top_m = std::max(top_m, box.high.y());
  }
  StandingGroups groups = standing_groups(blocks);
  const double crest_m = groups.all.empty() ? top_m : retaining_top_m(groups);
  return {bottom_m, crest_m, std::move(groups)};
}

/// A lower structure, such as a dam before a power house, is drowned: what was to press on it presses on its both
/// sides.
void warn_of_drowned(const Reading& reading, const Place& place, const char* key, double high_m, const Heights& model) {
  const StandingGroup* drowned = nullptr;
  const StandingGroup* holds = nullptr;
  for (const StandingGroup& group : model.groups.all) {
    if (!group.on_ground) continue;
    if (group.top_m < high_m && (drowned == nullptr || group.top_m > drowned->top_m)) drowned = &group;
    if (group.top_m >= high_m && holds == nullptr) holds = &group;
  }
  if (drowned == nullptr || holds == nullptr) return;
  const auto name = [&](const StandingGroup* group) { return reading.scene.blocks[at(group->highest)].name; };
  reading.problems.warning(
      place,
      fmt::format("{} reaches {:.6g} m, above \"{}\" and all that touches it, up to {:.6g} m: they "
                  "then stand in water on both sides, as \"{}\" holds it back",
                  key, high_m, name(drowned), drowned->top_m, name(holds)),
      "a level below the top of the structure that is judged",
      "lower the level if that is the lower one; fixed = true makes ground of the other");
}

}  // namespace

void check_level_heights(const Reading& reading) {
  const Scene& scene = reading.scene;
  const bool sound =
      reading.blocks.complete() && !scene.blocks.empty() &&
      std::none_of(scene.blocks.begin(), scene.blocks.end(), [](const Block& block) { return block.vertices.empty(); });
  const Water& water = scene.water;
  if (!sound || (!water.upstream_level_m && !water.downstream_level_m)) return;
  const Heights model = heights_of(scene.blocks);
  const double round_off_m = 1e-9 * (model.crest_m - model.bottom_m);  // of a ramp up to the crest
  for (const auto& [key, level] :
       {std::pair{"upstream_level_m", &water.upstream_level_m}, {"downstream_level_m", &water.downstream_level_m}}) {
    if (!*level) continue;
    const Place place = reading.problems.at(reading.file["water"][key].node()->source());
    const auto [low, high] = extremes(**level, scene.analysis.duration_s);
    if (high > model.crest_m + round_off_m && !water.may_overtop) {
      reading.problems.error(
          place, fmt::format("{} reaches {:.6g} m, above the structure's top at {:.6g} m", key, high, model.crest_m),
          "a level within the structure", "lower the level, or set may_overtop = true in [water] if that is meant");
    }
    warn_of_drowned(reading, place, key, high - round_off_m, model);
    if (low < model.bottom_m - round_off_m) {
      reading.problems.error(
          place,
          fmt::format("{} falls to {:.6g} m, below the model's lowest vertex at {:.6g} m", key, low, model.bottom_m),
          "a level within the model", "raise the level, or leave it out where there is no water");
    }
  }
}

}  // namespace blockweir::scene
