// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/slipped_body.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "bridge/scene/crumbs.hpp"
#include "solid/watch/failed_joint.hpp"
#include "solid/watch/failure_mode.hpp"
#include "solid/watch/moving_body.hpp"

namespace blockweir::solid {
namespace {

/// The contact that has slipped most, one between other blocks than crumbs if such a one has; null if none has.
const ContactPoint* most_slipped(const Solid& solid) {
  const std::vector<bool> crumbs = scene::crumbs(solid.scene().blocks);
  const auto key = [&](const ContactPoint& c) {
    const bool of_crumb = crumbs[at(c.vertex_block)] || crumbs[at(c.edge_block)];
    return std::pair(c.slip_path_m > 0 && !of_crumb, c.slip_path_m);
  };
  const auto& contacts = solid.contacts();
  const auto most = std::max_element(contacts.begin(), contacts.end(),
                                     [&](const ContactPoint& c, const ContactPoint& d) { return key(c) < key(d); });
  return most == contacts.end() || most->slip_path_m <= 0 ? nullptr : &*most;
}

}  // namespace

std::optional<Failure> slipped_body(const Solid& solid, double level_m) {
  const ContactPoint* most = most_slipped(solid);
  if (most == nullptr) return std::nullopt;
  const std::vector<Vector6> drawn(solid.described(), Vector6::Zero());
  const MovedSince moved(solid, drawn, std::vector<double>(drawn.size(), 0));
  const PairMotions pairs = pair_motions(moved);
  const auto [a, b] = most->pair();
  const bool second =
      solid.blocks()[at(a)].fixed || (!solid.blocks()[at(b)].fixed && moved.farthest(b) > moved.farthest(a));
  const int block = second ? b : a;
  const std::vector<bool> none(drawn.size(), false);
  const MovingBody body = moving_body(moved, pairs, none, none, block);
  const Mode mode = mode_of(moved, body, pairs);
  const FailedJoint joint = failed_joint(solid, body, pairs, mode.turns, /*from_downstream=*/false);
  Failure failure{.blocks = body.blocks,
                  .time_s = solid.time_s(),
                  .level_m = level_m,
                  .head_m = std::numeric_limits<double>::quiet_NaN(),
                  .bound = true,
                  .travel_m = moved.farthest(block),
                  .mode = mode.word(),
                  .joint = joint.name};
  if (joint.line) failure.head_m = level_m - joint.line->from.y();
  return failure;
}

}  // namespace blockweir::solid
