// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/push_apart.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/solve/least_push.hpp"

namespace blockweir::solid {

EdgeFrame PushApart::frame_now(const ContactPoint& c) const {
  return edge_frame(trial_.at_start(), c);
}

/// Gap of a contact where its blocks are now: what rounded coordinates left at the start and what its slip has opened
/// are no part of it, nor what its spring gives way.
/// A vertex farther beside the edge than behind it is not in its block.
double PushApart::gap_now(const ContactPoint& c) const {
  const EdgeFrame edge = frame_now(c);
  const Point along = state_.place(c) - state_.placements[at(c.edge_part)].position(c.edge_from);
  const double gap =
      edge.n.dot(along) - c.gap_at_start - model_.laws[c.law].dilation_m(c.slip_m) - formulation_->gap_under_force_m(c);
  const double s = edge.t.dot(along);
  const double beside = std::max(-s, s - edge.length);
  return beside > std::max(-gap, 2e-7 * model_.size_m) ? std::max(gap, beside) : gap;
}

bool PushApart::push(const IslandEquations& s) {
  constexpr int most = 3;  // pushes turn blocks
  const FormulationSettings& settings = formulation_->settings();
  if (settings.lasting_overlap_m == 0) return false;
  // Newton's method leaves none but those that a swept step had left.
  const auto was_left = [&](int k) { return state_.contacts[at(k)].overlap_m < -settings.lasting_overlap_m; };
  if (s.found != Found::by_sweeps && std::none_of(s.island.contacts.begin(), s.island.contacts.end(), was_left))
    return false;
  const auto overlaps = [&](int k) { return gap_now(state_.contacts[at(k)]) < -settings.lasting_overlap_m; };
  const auto any = [&] { return std::any_of(s.island.contacts.begin(), s.island.contacts.end(), overlaps); };
  int pushes = 0;
  while (pushes < most && any()) push_once(s), ++pushes;
  for (const int k : s.island.contacts) {
    ContactPoint& c = state_.contacts[at(k)];
    const double gap = gap_now(c);
    c.overlap_m = std::min(0.0, gap);
    c.gap = gap + model_.laws[c.law].dilation_m(c.slip_m) + formulation_->gap_under_force_m(c);
    counts_.overlap_m = std::max(counts_.overlap_m, -c.overlap_m);
  }
  return pushes > 0;
}

void PushApart::push_once(const IslandEquations& s) {
  std::vector<int> bodies;
  for (const int k : s.island.contacts) {
    for (const int b : {state_.contacts[at(k)].vertex_block, state_.contacts[at(k)].edge_block}) {
      if (!model_.blocks[at(b)].fixed) bodies.push_back(b);
    }
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  for (const int k : s.island.supports) std::erase(bodies, state_.supports[at(k)].described->block);
  const auto number = [&](int b) {
    const auto found = std::lower_bound(bodies.begin(), bodies.end(), b);
    return found == bodies.end() || *found != b ? -1 : static_cast<int>(found - bodies.begin());
  };
  std::vector<Eigen::Vector3d> mass;
  for (const int b : bodies) {
    const Inertia& inertia = model_.blocks[at(b)].inertia;
    mass.emplace_back(inertia.mass(), inertia.mass(), inertia.of_turn());
  }
  std::vector<Overlap> overlaps;

  for (const int k : s.island.contacts) {
    const ContactPoint& c = state_.contacts[at(k)];
    const Point n = frame_now(c).n;
    Overlap& o = overlaps.emplace_back(gap_now(c));
    for (const bool second : {false, true}) {
      const int b = second ? c.edge_block : c.vertex_block;
      const double turns = n.dot(perpendicular(state_.place(c) - state_.placements[at(b)].centre()));
      o.ends[second ? 1 : 0] = {number(b), (second ? -1 : 1) * Eigen::Vector3d(n.x(), n.y(), turns)};
    }
  }
  LeastPush push(std::move(mass), std::move(overlaps));

  push.solve(formulation_->settings().lasting_overlap_m);
  // What sticks does so where it has been pushed to.
  for (const int k : s.island.contacts) {
    ContactPoint& c = state_.contacts[at(k)];
    if (c.state == ContactState::open) continue;
    const EdgeFrame edge = frame_now(c);
    const auto moved = [&](int b) {
      if (number(b) < 0) return 0.0;
      const Eigen::Vector3d& by = push.moved(at(number(b)));
      return edge.t.dot(by.head<2>() + by[2] * perpendicular(state_.place(c) - state_.placements[at(b)].centre()));
    };
    c.anchor += (moved(c.vertex_block) - moved(c.edge_block)) / edge.length;
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) displace(at(bodies[k]), push.moved(k));
}

/// A block, and the triangles of its mesh, by (x, y, turn) about its centre. The work against its loads is owed.
void PushApart::displace(std::size_t block, const Eigen::Vector3d& by) {
  if (by.isZero(0)) return;
  const Point centre = state_.placements[block].centre();
  const auto move_with = [&](std::size_t b) {
    const Point arm = state_.placements[b].centre() - centre;
    const Point turned = Eigen::Rotation2Dd(by[2]) * arm - arm;
    const Eigen::Vector3d own(by[0] + turned.x(), by[1] + turned.y(), by[2]);
    if (!trial_.frozen[b]) {
      state_.energy.owe(b, state_.energy.owed(b) - trial_.external[b].head<3>().dot(own), model_.blocks.size());
    }
    state_.blocks[b].displacement.head<3>() += own;
    state_.sleep.wake(b);
    state_.placements[b] = Placement(model_.blocks[b].centroid, state_.blocks[b].displacement);
  };
  move_with(block);
  for (const int t : model_.parts.triangles[block]) move_with(at(t));
}

}  // namespace blockweir::solid
