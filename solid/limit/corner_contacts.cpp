// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/corner_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid::limit {
namespace {

using geometry::cross;
using Outline = std::vector<Point>;

constexpr double parallel = 1e-6;  // rad

std::size_t next(const Outline& outline, std::size_t i) {
  return (i + 1) % outline.size();
}
Point direction(const Outline& outline, std::size_t edge) {
  return (outline[next(outline, edge)] - outline[edge]).normalized();
}
bool is_convex(const Outline& outline, std::size_t vertex) {
  const std::size_t before = (vertex + outline.size() - 1) % outline.size();
  return cross(direction(outline, before), direction(outline, vertex)) > parallel;
}

bool is_reflex(const Outline& outline, std::size_t vertex) {
  const std::size_t before = (vertex + outline.size() - 1) % outline.size();
  return cross(direction(outline, before), direction(outline, vertex)) < -parallel;
}

bool in_kink(const Outline& outline, std::size_t edge, const Point& p, double touching_m) {
  const auto stands_in = [&](std::size_t vertex) {
    return (p - outline[vertex]).norm() <= touching_m && is_reflex(outline, vertex);
  };
  return stands_in(edge) || stands_in(next(outline, edge));
}

/// Does the edge hold a corner of another block at p?
bool holds(const Outline& outline, std::size_t edge, const Point& p, double touching_m) {
  const Point& from = outline[edge];
  const Point& to = outline[next(outline, edge)];
  if (geometry::distance_to_segment(p, from, to) > touching_m) return false;
  if ((p - from).norm() <= touching_m) return !is_convex(outline, edge);
  if ((p - to).norm() <= touching_m) return !is_convex(outline, next(outline, edge));
  return true;
}

/// Does a face that runs along the edge reach p? `edge_of`: the face's edge in that outline.
bool face_reaches(const scene::JointTrace& trace, int scene::TracePiece::*edge_of, const Outline& outline,
                  std::size_t edge, const Point& p, double touching_m) {
  return std::any_of(trace.pieces.begin(), trace.pieces.end(), [&](const scene::TracePiece& piece) {
    const bool along = at(piece.*edge_of) == edge ||
                       std::abs(cross((piece.to_m - piece.from_m).normalized(), direction(outline, edge))) < parallel;
    return along && geometry::distance_to_segment(p, piece.from_m, piece.to_m) <= touching_m;
  });
}

bool known(const std::vector<CornerContact>& contacts, const CornerContact& one, double touching_m) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const CornerContact& c) {
    return (c.at_m - one.at_m).norm() <= touching_m && (c.normal - one.normal).norm() < parallel;
  });
}

}  // namespace

std::vector<CornerContact> corner_contacts(const scene::Block& a, const scene::Block& b, const scene::JointTrace& trace,
                                           double touching_m) {
  std::vector<CornerContact> contacts;
  const auto add = [&](const Outline& corners, const Outline& edges, int scene::TracePiece::*edge_of, double sign) {
    for (const Point& p : corners) {
      for (std::size_t e = 0; e < edges.size(); ++e) {
        if (!holds(edges, e, p, touching_m) || face_reaches(trace, edge_of, edges, e, p, touching_m)) continue;
        const Point along = direction(edges, e);
        const CornerContact found{p, sign * Point(along.y(), -along.x()), in_kink(edges, e, p, touching_m)};
        if (!known(contacts, found, touching_m)) contacts.push_back(found);
      }
    }
  };
  add(a.vertices, b.vertices, &scene::TracePiece::edge_b, -1);
  add(b.vertices, a.vertices, &scene::TracePiece::edge_a, 1);
  return contacts;
}

}  // namespace blockweir::solid::limit
