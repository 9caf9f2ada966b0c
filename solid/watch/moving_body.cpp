// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/moving_body.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

/// All blocks that `start` reaches over pairs for which `joins` holds, seen from the block reached first.
std::set<int> reached(const std::set<int>& start, const PairMotions& pairs,
                      const std::function<bool(int from, int to, const PairMotion&)>& joins) {
  std::map<int, std::vector<std::pair<int, const PairMotion*>>> neighbours;
  for (const auto& [pair, motion] : pairs) {
    neighbours[pair.first].emplace_back(pair.second, &motion);
    neighbours[pair.second].emplace_back(pair.first, &motion);
  }
  std::set<int> found = start;
  std::vector<int> open(start.begin(), start.end());
  while (!open.empty()) {
    const int from = open.back();
    open.pop_back();
    for (const auto& [to, motion] : neighbours[from]) {
      if (found.contains(to) || !joins(from, to, *motion)) continue;
      found.insert(to);
      open.push_back(to);
    }
  }
  return found;
}

}  // namespace

MovedSince::MovedSince(const Solid& solid, const std::vector<Vector6>& displacement, const std::vector<double>& time_s)
    : solid_(solid), displacement_(displacement) {
  const Point now = solid.model().base.displacement(solid.time_s());
  for (std::size_t b = 0; b < displacement.size(); ++b) {
    then_.emplace_back(solid.blocks()[b].centroid, displacement[b]);
    base_.push_back(now - solid.model().base.displacement(time_s[b]));
  }
}

Point MovedSince::operator()(int block, const Point& X) const {
  return solid_.placements()[at(block)].displacement(X) - then_[at(block)].displacement(X) - base_[at(block)];
}

Point MovedSince::of_part(int block, int part, const Point& X) const {
  const auto& blocks = solid_.blocks();
  return (*this)(block, X + blocks[at(part)].centroid - blocks[at(block)].centroid);
}

Point MovedSince::of_vertex(const ContactPoint& c) const {
  return of_part(c.vertex_block, c.vertex_part, c.vertex_at);
}

Point MovedSince::of_foot(const ContactPoint& c) const {
  return of_part(c.edge_block, c.edge_part, c.edge_from + c.anchor * (c.edge_to - c.edge_from));
}

double MovedSince::farthest(int block) const {
  double farthest = 0;
  for (const Point& X : solid_.blocks()[at(block)].vertices) farthest = std::max(farthest, (*this)(block, X).norm());
  return farthest;
}

double MovedSince::turned(int block) const {
  return solid_.states()[at(block)].displacement[2] - displacement_[at(block)][2];
}

PairMotions pair_motions(const MovedSince& moved) {
  PairMotions pairs;
  for (const ContactPoint& c : moved.solid().contacts()) {
    const Point vertex = moved.of_vertex(c);
    const Point foot = moved.of_foot(c);
    PairMotion& pair = pairs[c.pair()];
    pair.points.extend(moved.solid().placements()[at(c.vertex_part)].position(c.vertex_at));
    const double relative = (vertex - foot).norm();
    pair.moved = std::max({pair.moved, vertex.norm(), foot.norm()});
    pair.relative = std::max(pair.relative, relative);
    if (c.state == ContactState::open) continue;
    pair.slip = std::max(pair.slip, relative);
    pair.normal += c.force.x();
  }
  return pairs;
}

MovingBody moving_body(const MovedSince& moved, const PairMotions& pairs, const std::vector<bool>& stands,
                       const std::vector<bool>& led, int block) {
  constexpr double apart = 0.1;
  const auto& blocks = moved.solid().blocks();
  const double travel = moved.farthest(block);
  const auto base = [&](int b) { return blocks[at(b)].fixed || led[at(b)]; };
  const auto together = [&](int, int to, const PairMotion& p) { return !base(to) && p.relative < apart * p.moved; };
  const auto stays = [&](int b) { return base(b) || stands[at(b)] || moved.farthest(b) < travel / 2; };
  const auto left_behind = [&](const std::set<int>& body) {
    std::vector<std::pair<int, int>> left;
    std::vector<std::pair<int, int>> opposite;  // goes the other way, and so carries nothing along
    for (const auto& [pair, motion] : pairs) {
      const auto [a, b] = pair;
      if (body.contains(a) == body.contains(b)) continue;
      const auto [inside, outside] = body.contains(a) ? std::pair(a, b) : std::pair(b, a);
      if (stays(outside)) left.emplace_back(inside, outside);
      if (!stays(outside) && motion.slip > travel) opposite.emplace_back(inside, outside);
    }
    const auto bears = [&](const std::pair<int, int>& p) {
      return pairs.at(std::minmax(p.first, p.second)).normal > 0;
    };
    if (std::none_of(left.begin(), left.end(), bears)) left.insert(left.end(), opposite.begin(), opposite.end());
    return left;
  };
  std::set<int> body = reached({block}, pairs, together);
  auto left = left_behind(body);
  if (left.empty()) {
    std::set<int> all = reached(body, pairs, [&](int, int to, const PairMotion&) { return !stays(to); });
    if (left = left_behind(all); !left.empty()) body = std::move(all);
  }
  return {{body.begin(), body.end()}, std::move(left)};
}

}  // namespace blockweir::solid
