// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/pools.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bridge/results/stopwatch.hpp"

namespace blockweir::hydrostatic {
namespace {

/// But for round-off; no level equals none.
bool as_high(double a_m, double b_m) {
  return std::abs(a_m - b_m) <= 1e-12 * std::max(std::abs(a_m), std::abs(b_m));
}

/// A crest that the scene draws above the level. NaN: no.
bool has_sunk_below(const Structure& structure, double level_m) {
  return level_m <= structure.crest_drawn_m && level_m > crest_m(structure) + structure.open_crack_width_m;
}

}  // namespace

std::vector<WetInterval> wet_intervals(const std::vector<WaterBody>& bodies) {
  std::vector<WetInterval> all;
  for (const WaterBody& body : bodies) all.insert(all.end(), body.wet->intervals.begin(), body.wet->intervals.end());
  std::sort(all.begin(), all.end(), [](const WetInterval& a, const WetInterval& b) {
    return std::tie(a.block, a.edge, a.s_from) < std::tie(b.block, b.edge, b.s_from);
  });
  return all;
}

Pools::State Pools::find(const Structure& structure, double upstream_m, double downstream_m, scene::CrestPressure law) {
  if (as_high(upstream_m, downstream_m)) {
    return {{{Surface::level(upstream_m), &wet(structure, both, upstream_m)}}, false};
  }
  State state;
  const auto add = [&](Kind kind, double level_m) {
    if (std::isnan(level_m)) return;
    const WetFaces& faces = wet(structure, kind, level_m);
    state.breached = state.breached || faces.breached;
    state.bodies.push_back({Surface::level(level_m), &faces});
  };
  add(upstream, upstream_m);
  add(downstream, downstream_m);
  const bool connected = state.breached;
  state.breached = connected || has_sunk_below(structure, upstream_m) || has_sunk_below(structure, downstream_m);
  if (state.bodies.size() < 2) return state;
  const double lower_m = std::min(upstream_m, downstream_m);
  if (connected) {
    state.bodies = {{Surface::level(upstream_m), &wet(structure, upstream_part, upstream_m)},
                    {Surface::level(downstream_m), &wet(structure, downstream_part, downstream_m)}};
  } else if (lower_m > crest_m(structure)) {
    state.bodies.push_back(
        {over_the_crest(structure, upstream_m, downstream_m, law), &over_crest(structure, state, lower_m)});
  }
  return state;
}

const WetFaces& Pools::over_crest(const Structure& structure, const State& pools, double lower_m) {
  over_crest_ = {without(wet(structure, both, lower_m).intervals,
                         {&pools.bodies[0].wet->intervals, &pools.bodies[1].wet->intervals}),
                 {}};
  return over_crest_;
}

const WetFaces& Pools::wet(const Structure& structure, Kind kind, double level_m) {
  std::optional<Kept>& kept = kept_[kind];
  if (kept && kept->level_m == level_m) {
    ++repeats_;
    return kept->faces;
  }
  const Stopwatch watch(search_s_);
  ++searches_;
  kept = Kept{level_m, search(structure, kind, level_m)};
  if (kind <= downstream) behind_[kind] = kept->faces.behind;
  return kept->faces;
}

WetFaces Pools::search(const Structure& structure, Kind kind, double level_m) const {
  switch (kind) {
    case upstream:
      return wet_faces(structure, Pool::upstream, level_m, behind_[upstream]);
    case downstream:
      return wet_faces(structure, Pool::downstream, level_m, behind_[downstream]);
    case upstream_part:
      return wet_faces_up_to_the_crest(structure, Pool::upstream, level_m);
    case downstream_part:
      return wet_faces_up_to_the_crest(structure, Pool::downstream, level_m);
    default:
      return wet_faces_of_both(structure, level_m);
  }
}

}  // namespace blockweir::hydrostatic
