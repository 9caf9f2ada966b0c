// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/current_outlines.hpp"

namespace blockweir::solid {

CurrentOutlines::CurrentOutlines(const MovingParts& parts, double size_m)
    : parts_(parts), corners_(parts.contact_outlines.size()), coincidence_(1e-7 * size_m), give_(2 * coincidence_) {
  edges_.resize(corners_.size());
  for (std::size_t b = 0; b < corners_.size(); ++b) {
    corners_[b].resize(parts.contact_outlines[b].size());
    edges_[b].resize(parts.contact_outlines[b].size());
  }
}

void CurrentOutlines::move(std::size_t block, const std::vector<Placement>& placements) {
  const ContactOutline& sides = parts_.contact_outlines[block];
  for (std::size_t v = 0; v < sides.size(); ++v) {
    corners_[block][v] = placements[at(sides[v].part)].position(sides[v].from);
  }
  for (std::size_t e = 0; e < sides.size(); ++e) {
    const Point span = corners_[block][next(e, sides.size())] - corners_[block][e];
    const double length_m = span.norm();
    edges_[block][e] = {span / length_m, length_m};
  }
}

std::pair<Point, Point> CurrentOutlines::edge_of(const ContactPoint& c) const {
  const auto& E = of(c.edge_block);
  const auto e = at(c.edge);
  return {E[e], E[next(e, E.size())]};
}

Point CurrentOutlines::normal_of(const ContactPoint& c) const {
  const Point& t = edges(c.edge_block)[at(c.edge)].along;
  return {t.y(), -t.x()};
}

bool CurrentOutlines::of_one_joint(const ContactPoint& a, const ContactPoint& b) const {
  if (a.pair() != b.pair()) return false;
  return normal_of(a).dot(normal_of(b)) * (a.vertex_block == b.vertex_block ? 1 : -1) >= 1 - parallel_tolerance;
}

double CurrentOutlines::turned(const ContactPoint& a, const ContactPoint& b) const {
  return std::abs(cross(normal_of(a), normal_of(b)));
}

void CurrentOutlines::count_from_start(ContactPoint& c) const {
  if (c.gap_at_start == 0) return;
  c.gap -= c.gap_at_start;
  c.separation -= c.gap_at_start * normal_of(c);
}

bool CurrentOutlines::rounds_to(double rounding_m) {
  if (2 * rounding_m <= coincidence_) return false;
  coincidence_ = 2 * rounding_m;
  give_ = std::max(2 * coincidence_, give_);
  return true;
}

}  // namespace blockweir::solid
