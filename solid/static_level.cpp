// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/static_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "solid/static_blocks.hpp"
#include "solid/watch/edge_tension.hpp"

namespace blockweir::solid {
namespace {

/// How the blocks leave a level at which they rest for one at which they do not.
std::optional<Failure> failure_of(StaticBlocks& blocks, const std::string& resting, double level_m, double next_m) {
  blocks.restore(resting);
  FailureWatch watch(blocks.solid());
  watch.look(0, blocks.levels(level_m));
  if (blocks.rests_at(next_m, 1)) return std::nullopt;
  watch.look(1, blocks.levels(next_m));
  if (watch.failures().empty()) return std::nullopt;
  return watch.failures().front();
}

std::string warning_of(StaticBlocks& blocks, const std::string& resting, double level_m) {
  blocks.restore(resting);
  EdgeTension edge;
  edge.look(blocks.solid(), std::numeric_limits<double>::quiet_NaN(), level_m);
  return edge.warning();
}

}  // namespace

StaticLevel static_level(const scene::Scene& scene, StillWater& water, double width) {
  constexpr int rises = 20;
  constexpr double seen = 1e-4;  // beyond the level, so that how the blocks fail is seen
  const auto [empty_m, full_m] = water.range();
  const double range_m = full_m - empty_m;
  Effort effort("level by the blocks");
  StaticBlocks blocks(scene, &water, effort);
  if (!blocks.begin(empty_m)) return {.level_m = empty_m};
  double rests_m = empty_m;
  double fails_m = full_m + range_m / rises;  // no level yet
  std::string resting = blocks.state();
  const auto narrow = [&] {
    while (rests_m < full_m && fails_m - rests_m > width * range_m) {
      effort.knows(fmt::format("rests at {:.9g} m", rests_m) +
                   (fails_m > full_m ? "" : fmt::format(", fails at {:.9g} m", fails_m)));
      const double next_m = fails_m > full_m ? std::min(full_m, rests_m + range_m / rises) : (rests_m + fails_m) / 2;
      if (next_m <= rests_m || next_m >= fails_m) break;
      // What only strains moves less under a small rise, and what slips need not be followed as far.
      const double share = std::clamp(10 * (next_m - rests_m) / range_m, 1e-5, 1.0);
      if (blocks.rests_at(next_m, share)) {
        rests_m = next_m;
        resting = blocks.state();
      } else {
        fails_m = next_m;
        blocks.restore(resting);
      }
    }
  };
  StaticLevel found;
  try {
    narrow();
    found.warning = warning_of(blocks, resting, rests_m);
    if (fails_m <= full_m) found.failure = failure_of(blocks, resting, rests_m, fails_m + seen * range_m);
  } catch (const TookTooLong& stopped) {
    if (rests_m < full_m && fails_m > full_m) throw;
    if (fails_m - rests_m > width * range_m) found.stopped = stopped.what();
  }
  const bool fails = fails_m <= full_m;
  found.outcome = fails ? limit::Filled::fails : limit::Filled::stands_full;
  found.level_m = fails ? (rests_m + fails_m) / 2 : full_m;
  found.width_m = fails ? fails_m - rests_m : 0;
  return found;
}

}  // namespace blockweir::solid
