// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/push_apart.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/contact/outline.hpp"
#include "solid/solve/overlap_projection.hpp"

namespace blockweir::solid {

void PushApart::meet(const IslandEquations& s) {
  const std::size_t contacts = s.island.contacts.size();
  meetings_.resize(contacts + passing_.size());
  in_pieces(meetings_.size(), [&](std::size_t first, std::size_t end) {
    Meetings now(step_);
    for (std::size_t i = first; i < end; ++i) {
      meetings_[i] = i < contacts ? now.of_contact(state_.contacts[at(s.island.contacts[i])])
                                  : now.of_passing(*passing_[i - contacts]);
    }
  });
}

/// What may last of an island's overlaps: more where many blocks fall, as most of their pushes went into the rest.
double PushApart::lasting_m(const IslandEquations& s) const {
  constexpr double more = 10;
  const bool many_fall = s.unknowns->total > large_island && trial_.falls();
  return (many_fall ? more : 1) * formulation_->settings().lasting_overlap_m;
}

/// What may be left after some pushes. Of thousands of blocks ever more have to give way to each: pushes are slow.
double PushApart::enough_m(const IslandEquations& s, int pushes) const {
  constexpr int few_pushes = 2;
  constexpr int thousands = 3000;  // unknowns
  constexpr double share_of_extent = 5e-8;
  if (pushes < few_pushes || s.unknowns->total <= thousands) return lasting_m_;
  Eigen::AlignedBox2d extent;
  for (const int b : s.island.blocks) extent.extend(state_.placements[at(b)].centre());
  return std::max(lasting_m_, share_of_extent * extent.sizes().maxCoeff());
}

double PushApart::left_by_sweeps_m(const IslandEquations& s) const {
  double left_m = 0;
  for (const int k : s.island.contacts) {
    const double gap = formulation_->progress().contact(k).separation.x();
    left_m = std::max(left_m, formulation_->gap_under_force_m(state_.contacts[at(k)]) - gap);
  }
  return left_m;
}

bool PushApart::push(const IslandEquations& s) {
  constexpr int most = 10;  // pushes turn blocks, and what they had not met is met then
  const double lasting = lasting_m_ = lasting_m(s);
  if (lasting == 0) return false;
  // Newton's method leaves none but those that a swept step had left.
  const auto was_left = [&](int k) { return state_.contacts[at(k)].overlap_m < -lasting; };
  if (s.found != Found::by_sweeps && std::none_of(s.island.contacts.begin(), s.island.contacts.end(), was_left))
    return false;
  int pushes = 0;
  passing_.clear();
  meet(s);
  // What stands keeps its corners where they are.
  if (trial_.falls()) {
    const double deepest_m = this->deepest_m();
    passing_ = state_.search.passing(s.island.blocks);
    std::erase_if(passing_, [&](const ContactPoint* c) { return !now_.corners_touch(*c, trial_.moved_m, deepest_m); });
    for (const ContactPoint* c : passing_) meetings_.push_back(now_.of_passing(*c));
  }
  for (; pushes < most && deepest_m() > enough_m(s, pushes); ++pushes) push_once(s);
  for (std::size_t i = 0; i < s.island.contacts.size(); ++i) {
    ContactPoint& c = state_.contacts[at(s.island.contacts[i])];
    const double gap = std::isinf(meetings_[i].gap) ? 0 : meetings_[i].gap;
    c.overlap_m = std::min(0.0, gap);
    c.gap = gap + model_.laws[c.law].dilation_m(c.slip_m) + formulation_->gap_under_force_m(c);
    counts_.overlap_m = std::max(counts_.overlap_m, -c.overlap_m);
  }
  return pushes > 0;
}

double PushApart::deepest_m() const {
  double deepest = 0;
  for (const Meeting& m : meetings_) deepest = std::max(deepest, -m.gap);
  return deepest;
}

void PushApart::push_once(const IslandEquations& s) {
  const Push push = find_push(s);
  carry_out(s, push, affordable(push, deepest_m()));
  meet(s);
}

/// No block is pushed farther than the step has moved one and leaves it in another, nor turned farther than a step may.
double PushApart::affordable(const Push& push, double deepest_m) const {
  const double farthest_m = trial_.moved_m + deepest_m;
  double share = 1;
  for (std::size_t k = 0; k < push.bodies.size(); ++k) {
    const double turn = std::abs(push.moved[k][2]);
    const double way_m = push.moved[k].head<2>().norm() + model_.blocks[at(push.bodies[k])].radius * turn;
    if (share * way_m > farthest_m) share = farthest_m / way_m;
    if (share * turn > most_turn_in_step) share = most_turn_in_step / turn;
  }
  return share;
}

PushApart::Push PushApart::find_push(const IslandEquations& s) const {
  Push push;
  for (const int k : s.island.contacts) {
    for (const int b : {state_.contacts[at(k)].vertex_block, state_.contacts[at(k)].edge_block}) {
      if (!model_.blocks[at(b)].fixed) push.bodies.push_back(b);
    }
  }
  std::sort(push.bodies.begin(), push.bodies.end());
  push.bodies.erase(std::unique(push.bodies.begin(), push.bodies.end()), push.bodies.end());
  for (const int k : s.island.supports) std::erase(push.bodies, state_.supports[at(k)].described->block);
  std::vector<Eigen::Vector3d> mass;
  for (const int b : push.bodies) {
    const Inertia& inertia = model_.blocks[at(b)].inertia;
    mass.emplace_back(inertia.mass(), inertia.mass(), inertia.of_turn());
  }
  std::vector<Overlap> overlaps(meetings_.size());
  for_each(meetings_.size(), [&](std::size_t i) {
    const Meeting& m = meetings_[i];
    const Point& n = m.normal;
    Overlap& o = overlaps[i];
    o.gap = m.gap;
    for (const bool second : {false, true}) {
      const int b = second ? m.face_block : m.corner_block;
      const double turns = n.dot(perpendicular(m.corner - state_.placements[at(b)].centre()));
      o.ends[second ? 1 : 0] = {push.number(b), (second ? -1 : 1) * Eigen::Vector3d(n.x(), n.y(), turns)};
    }
  });
  OverlapProjection projection(mass, overlaps);
  projection.solve(lasting_m_);
  for (std::size_t k = 0; k < push.bodies.size(); ++k) push.moved.push_back(projection.moved(k));
  return push;
}

int PushApart::Push::number(int b) const {
  const auto found = std::lower_bound(bodies.begin(), bodies.end(), b);
  return found == bodies.end() || *found != b ? -1 : static_cast<int>(found - bodies.begin());
}

/// What sticks does so where it has been pushed to.
void PushApart::carry_out(const IslandEquations& s, const Push& push, double share) {
  for_each(s.island.contacts.size(), [&](std::size_t i) {
    ContactPoint& c = state_.contacts[at(s.island.contacts[i])];
    if (c.state == ContactState::open) return;
    const EdgeFrame edge = edge_frame(trial_.at_start(), c);
    const auto moved = [&](int b) {
      const int body = push.number(b);
      if (body < 0) return 0.0;
      const Eigen::Vector3d by = share * push.moved[at(body)];
      return edge.t.dot(by.head<2>() + by[2] * perpendicular(state_.place(c) - state_.placements[at(b)].centre()));
    };
    c.anchor += (moved(c.vertex_block) - moved(c.edge_block)) / edge.length;
  });
  for (std::size_t k = 0; k < push.bodies.size(); ++k) displace(at(push.bodies[k]), share * push.moved[k]);
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
