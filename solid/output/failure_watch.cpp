// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/failure_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "bridge/scene/at.hpp"
#include "solid/output/joint_name.hpp"

namespace blockweir::solid::output {

FailureWatch::FailureWatch(const Solid& solid) : solid_(solid), rest_(solid.described()), guided_(rest_.size()) {
  std::map<std::size_t, int> supports;
  for (const scene::Support& support : solid.scene().supports) {
    if (++supports[at(support.block)] == 2) guided_[at(support.block)] = true;
  }
}

double FailureWatch::speed(std::size_t b) const {
  double fastest = 0;
  const Point base = solid_.base().velocity(solid_.time_s());
  for (const Point& X : solid_.blocks()[b].vertices) {
    fastest = std::max(fastest, (solid_.placements()[b].shape(X) * solid_.states()[b].velocity - base).norm());
  }
  return fastest;
}

/// Farthest that a vertex has come since the block's last rest [m].
double FailureWatch::travel(std::size_t b) const {
  const Placement then(solid_.blocks()[b].centroid, rest_[b].displacement);
  const Point base = solid_.base().displacement(solid_.time_s()) - solid_.base().displacement(rest_[b].time_s);
  double farthest = 0;
  for (const Point& X : solid_.blocks()[b].vertices) {
    farthest = std::max(farthest, (solid_.placements()[b].position(X) - then.position(X) - base).norm());
  }
  return farthest;
}

/// Contacts with blocks at rest, one that sticks and another that is closed elsewhere, leave a block no rigid motion of
/// its own: it only strains.
bool FailureWatch::held(std::size_t b, const std::vector<const ContactPoint*>& closed,
                        const std::vector<bool>& resting) const {
  const auto point = [&](const ContactPoint* c) { return solid_.place(*c); };
  const auto holds = [&](const ContactPoint* c) {
    return resting[at(at(c->vertex_block) == b ? c->edge_block : c->vertex_block)];
  };
  const auto sticking = std::find_if(
      closed.begin(), closed.end(), [&](const ContactPoint* c) { return c->state == ContactState::stick && holds(c); });
  if (sticking == closed.end()) return false;
  const Point pivot = point(*sticking);
  const double elsewhere = 1e-3 * solid_.blocks()[b].radius;
  return std::any_of(closed.begin(), closed.end(),
                     [&](const ContactPoint* c) { return holds(c) && (point(c) - pivot).norm() > elsewhere; });
}

bool FailureWatch::calm() const {
  const std::vector<bool> still = resting();
  return std::all_of(still.begin(), still.end(), [](bool rests) { return rests; });
}

/// Blocks that are slow, and those that a load strains faster while others at rest hold them.
std::vector<bool> FailureWatch::resting() const {
  constexpr double straining =
      100;  // far above what fillings cause, far below the speed of a block that is carried away
  const double rest = solid_.scene().analysis.rest_speed_m_per_s;
  std::vector<bool> resting(rest_.size());
  std::map<std::size_t, std::vector<const ContactPoint*>> strained;  // with their closed contacts
  for (std::size_t b = 0; b < rest_.size(); ++b) {
    const double fastest = solid_.blocks()[b].fixed ? 0 : speed(b);
    resting[b] = fastest <= rest;
    if (!resting[b] && fastest <= straining * rest) strained[b];
  }
  if (strained.empty()) return resting;
  for (const ContactPoint& c : solid_.contacts()) {
    if (c.state == ContactState::open) continue;
    for (const int b : {c.vertex_block, c.edge_block}) {
      if (const auto found = strained.find(at(b)); found != strained.end()) found->second.push_back(&c);
    }
  }
  const auto come_to_rest = [&](const auto& block) {
    return resting[block.first] = held(block.first, block.second, resting);
  };
  while (std::erase_if(strained, come_to_rest) > 0) {
  }
  return resting;
}

void FailureWatch::look(double time_s, double upstream_level_m) {
  const scene::Analysis& analysis = solid_.scene().analysis;
  const std::vector<bool> at_rest = resting();
  for (std::size_t b = 0; b < rest_.size(); ++b) {
    if (solid_.blocks()[b].fixed || guided_[b] || rest_[b].failed) continue;
    if (at_rest[b] || time_s == 0) {
      rest_[b] = {.time_s = time_s, .level_m = upstream_level_m, .displacement = solid_.states()[b].displacement};
    } else if (travel(b) > analysis.failure_displacement_m) {
      rest_[b].failed = true;
      failures_.push_back(describe(b));
    }
  }
  std::stable_sort(failures_.begin(), failures_.end(),
                   [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
}

/// Of the neighbours that have not come half the way along (one that rings may be as fast), the one whose joint begins
/// farthest upstream; blocks that had no joint with this one count when they touch it now. -1 when there is none.
int FailureWatch::neighbour_left_behind(std::size_t b) const {
  int farthest = -1;
  double farthest_x = 0;
  for (const ContactPoint& c : solid_.contacts()) {
    const bool is_vertex = at(c.vertex_block) == b;
    if (!is_vertex && at(c.edge_block) != b) continue;
    const int other = is_vertex ? c.edge_block : c.vertex_block;
    if (!solid_.blocks()[at(other)].fixed && travel(at(other)) >= travel(b) / 2) continue;
    const auto trace = joint_trace(b, at(other));
    if (trace.pieces.empty() && c.state == ContactState::open) continue;
    const double x = trace.pieces.empty() ? std::numeric_limits<double>::max() : trace.mouth().x();
    if (farthest >= 0 && x >= farthest_x) continue;
    farthest = other;
    farthest_x = x;
  }
  return farthest;
}

scene::JointTrace FailureWatch::joint_trace(std::size_t a, std::size_t b) const {
  const auto& blocks = solid_.scene().blocks;
  return scene::trace_joint(blocks[a], blocks[b], 1e-6 * solid_.size_m());
}

/// Farthest that a closed contact of the two has slipped since the block's last rest [m].
double FailureWatch::slip(std::size_t b, std::size_t other) const {
  double farthest = 0;
  for (const ContactPoint& c : solid_.contacts()) {
    const std::size_t v = at(c.vertex_block);
    const std::size_t e = at(c.edge_block);
    if (c.state == ContactState::open || std::minmax(v, e) != std::minmax(b, other)) continue;
    const auto then = [&](std::size_t block, int part, const Point& X) {
      const Point& centroid = solid_.blocks()[block].centroid;
      return Placement(centroid, rest_[block].displacement).position(X + solid_.blocks()[at(part)].centroid - centroid);
    };
    const Point foot = c.edge_from + c.anchor * (c.edge_to - c.edge_from);
    farthest = std::max(farthest, (then(v, c.vertex_part, c.vertex_at) - then(e, c.edge_part, foot)).norm());
  }
  return farthest;
}

Failure FailureWatch::describe(std::size_t b) const {
  Failure failure{.block = static_cast<int>(b),
                  .time_s = rest_[b].time_s,
                  .level_m = rest_[b].level_m,
                  .head_m = std::numeric_limits<double>::quiet_NaN()};
  const int other = neighbour_left_behind(b);
  if (other < 0) {
    failure.mode = "falling";
    return failure;
  }
  // Shares of the way: a block that turns about its toe has about 1/2 of it from the turning, one that slides none.
  constexpr double turns = 0.02;
  constexpr double slides = 0.002;
  const double turned = std::abs(solid_.states()[b].displacement[2] - rest_[b].displacement[2]);
  const bool turning = turned * solid_.blocks()[b].radius > turns * travel(b);
  const bool sliding = slip(b, at(other)) > slides * travel(b);
  failure.mode = !turning ? "sliding" : sliding ? "sliding and overturning" : "overturning";
  failure.joint = joint_name(solid_, static_cast<int>(b), other);
  const auto trace = joint_trace(b, at(other));
  if (!trace.pieces.empty()) failure.head_m = failure.level_m - trace.mouth().y();
  return failure;
}

}  // namespace blockweir::solid::output
