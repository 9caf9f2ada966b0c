// SPDX-License-Identifier: GPL-3.0-or-later
// A failure as the watch tells it: the body, its mode and joint, and the level at which it was last at rest.
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"
#include "bridge/scene/constant_loads.hpp"
#include "solid/watch/failed_joint.hpp"
#include "solid/watch/failure_mode.hpp"
#include "solid/watch/failure_watch.hpp"
#include "solid/watch/moving_body.hpp"

namespace blockweir::solid {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

/// No water reaches anything that can move: the level has nothing to do with a failure.
bool FailureWatch::all_is_dry(double level_m) const {
  for (std::size_t b = 0; b < watched_.size(); ++b) {
    if (solid_.blocks()[b].fixed) continue;
    const Placement then(solid_.blocks()[b].centroid, watched_[b].displacement);
    for (const Point& X : solid_.blocks()[b].vertices) {
      if (then.position(X).y() < level_m) return false;
    }
  }
  return true;
}

bool FailureWatch::changing_pool(const Watched& last) const {
  if (last.next_s < 0) return last.levels.reversed();
  const auto changes = [&](bool downstream) {
    const double level_m = last.levels.of(downstream);
    return std::abs(last.next.of(downstream) - level_m) > 0 && !all_is_dry(level_m);
  };
  return changes(false) == changes(true) ? last.levels.reversed() : changes(true);
}

Failure FailureWatch::describe(std::size_t b) const {
  std::vector<Vector6> displacement;
  std::vector<double> times;
  for (const Watched& block : watched_) {
    displacement.push_back(block.displacement);
    times.push_back(block.time_s);
  }
  const MovedSince moved(solid_, displacement, times);
  const PairMotions pairs = pair_motions(moved);
  const MovingBody body = moving_body(moved, pairs, stands_, guided_, static_cast<int>(b));
  const Mode mode = mode_of(moved, body, pairs);
  const Watched& last = watched_[b];
  const bool in_time = solid_.scene().analysis.kind != scene::AnalysisKind::at_rest;
  const bool downstream = changing_pool(last);
  Failure failure{.blocks = body.blocks,
                  .time_s = in_time ? last.time_s : solid_.scene().analysis.duration_s,
                  .level_m = last.levels.of(downstream),
                  .downstream = downstream,
                  .falls = last.next_s >= 0 && last.next.of(downstream) < last.levels.of(downstream),
                  .head_m = nan,
                  .bound = !in_time || last.time_s == 0 || loads_stay_,
                  .level_uncertainty_m = nan,
                  .window_rise_m = nan,
                  .travel_m = travel(b),
                  .mode = mode.up ? "lifting" : "falling"};
  if (all_is_dry(failure.level_m)) failure.level_m = nan;
  const FailedJoint joint = failed_joint(solid_, body, pairs, mode.turns, last.levels.reversed());
  if (joint.name.empty()) {
    if (failure.bound && !mode.up) failure.level_m = nan;  // nothing has ever held it, whatever the level
    return failure;
  }
  failure.joint = joint.name;
  failure.turns_on = joint.turns_on;
  failure.mode = mode.word();
  if (!joint.line) return failure;
  failure.head_m = failure.level_m - (downstream ? joint.line->to : joint.line->from).y();
  if (!failure.bound && !scene::level_is_constant(solid_.scene(), downstream)) add_uncertainty(last, failure);
  return failure;
}

}  // namespace blockweir::solid
