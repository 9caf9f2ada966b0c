// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/limit/corner_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid::limit {
namespace {

using geometry::cross;
using Outline = std::vector<Point>;

constexpr double parallel = 1e-6;  // rad
constexpr double rounding = 1e-3;  // rad: outlines within the tolerance overlap by less, even along short edges

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

/// Does the edge hold a corner of another block at p, taken by itself?
bool holds(const Outline& outline, std::size_t edge, const Point& p, double touching_m) {
  const Point& from = outline[edge];
  const Point& to = outline[next(outline, edge)];
  if (geometry::distance_to_segment(p, from, to) > touching_m) return false;
  if ((p - from).norm() <= touching_m) return !is_convex(outline, edge);
  if ((p - to).norm() <= touching_m) return !is_convex(outline, next(outline, edge));
  return true;
}

/// Angle from one direction to the other, counter-clockwise, 0 to 2 pi; none where rounding turns it back.
double turn(const Point& from, const Point& to) {
  const double angle = std::atan2(cross(from, to), from.dot(to));
  return angle < -rounding ? angle + 2 * std::numbers::pi : std::max(angle, 0.0);
}

/// What an outline fills around a point of it: from one direction counter-clockwise to the other.
struct Sector {
  Point from;
  Point to;
};
std::optional<Sector> sector_at(const Outline& outline, const Point& p, double touching_m) {
  for (std::size_t e = 0; e < outline.size(); ++e) {
    if ((p - outline[e]).norm() > touching_m) continue;
    return Sector{direction(outline, e), -direction(outline, (e + outline.size() - 1) % outline.size())};
  }
  for (std::size_t e = 0; e < outline.size(); ++e) {
    if (geometry::distance_to_segment(p, outline[e], outline[next(outline, e)]) > touching_m) continue;
    return Sector{direction(outline, e), -direction(outline, e)};
  }
  return std::nullopt;
}

/// The free sector of a body in which a corner of a block stands: between the edges of the body next to it.
Sector room_of(const Sector& corner, const std::vector<Sector>& filled) {
  const auto before = [&](const Sector& s) { return turn(s.to, corner.from); };
  const auto after = [&](const Sector& s) { return turn(corner.to, s.from); };
  const auto nearer = [](const auto& gap) {
    return [&gap](const Sector& s, const Sector& t) { return gap(s) < gap(t); };
  };
  return {std::min_element(filled.begin(), filled.end(), nearer(before))->to,
          std::min_element(filled.begin(), filled.end(), nearer(after))->from};
}

/// The angle of the room of the block's corner at p, where the edge bounds it and it is no wider than a half plane.
std::optional<double> room_bounded_by(const Outline& outline, std::size_t edge, const scene::Block& block,
                                      const std::vector<Neighbour>& body, const Point& p, double touching_m) {
  if (geometry::distance_to_segment(p, outline[edge], outline[next(outline, edge)]) > touching_m) return std::nullopt;
  std::vector<Sector> filled;
  for (const Neighbour& part : body) {
    if (const auto sector = sector_at(part.block->vertices, p, touching_m)) filled.push_back(*sector);
  }
  const Sector room = room_of(*sector_at(block.vertices, p, touching_m), filled);
  const double angle = turn(room.from, room.to);
  if (angle > std::numbers::pi + parallel) return std::nullopt;
  const Point along = direction(outline, edge);
  const bool bounds = (along + room.from).norm() < parallel || (along - room.to).norm() < parallel;
  return bounds ? std::optional(angle) : std::nullopt;
}

/// Does a face of the block with the body that runs along the edge reach p? `edge_of`: the face's edge in that outline.
bool face_reaches(const std::vector<Neighbour>& body, int scene::TracePiece::*edge_of, const Outline& outline,
                  std::size_t edge, const Point& p, double touching_m) {
  const auto reaches = [&](const scene::TracePiece& piece, bool own) {
    const bool along = (own && at(piece.*edge_of) == edge) ||
                       std::abs(cross((piece.to_m - piece.from_m).normalized(), direction(outline, edge))) < parallel;
    return along && geometry::distance_to_segment(p, piece.from_m, piece.to_m) <= touching_m;
  };
  return std::any_of(body.begin(), body.end(), [&](const Neighbour& part) {
    const bool own = edge_of == &scene::TracePiece::edge_a || &part.block->vertices == &outline;
    return std::any_of(part.trace.pieces.begin(), part.trace.pieces.end(),
                       [&](const scene::TracePiece& piece) { return reaches(piece, own); });
  });
}

bool known(const std::vector<CornerContact>& contacts, const CornerContact& one, double touching_m) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const CornerContact& c) {
    return (c.at_m - one.at_m).norm() <= touching_m && (c.normal - one.normal).norm() < parallel;
  });
}

}  // namespace

std::vector<CornerContact> corner_contacts(const scene::Block& block, const std::vector<Neighbour>& body,
                                           const Neighbour& neighbour, double touching_m) {
  std::vector<CornerContact> contacts;
  const auto add = [&](const Point& p, const Outline& outline, std::size_t edge, double sign, bool kink) {
    const Point along = direction(outline, edge);
    const CornerContact found{p, sign * Point(along.y(), -along.x()), kink};
    if (!known(contacts, found, touching_m)) contacts.push_back(found);
  };
  const Outline& own = block.vertices;
  const Outline& others = neighbour.block->vertices;
  for (const Point& p : own) {
    for (std::size_t e = 0; e < others.size(); ++e) {
      const std::optional<double> room = room_bounded_by(others, e, block, body, p, touching_m);
      if (room && !face_reaches(body, &scene::TracePiece::edge_b, others, e, p, touching_m)) {
        add(p, others, e, -1, *room < std::numbers::pi - rounding);
      }
    }
  }
  for (const Point& p : others) {
    for (std::size_t e = 0; e < own.size(); ++e) {
      if (holds(own, e, p, touching_m) && !face_reaches(body, &scene::TracePiece::edge_a, own, e, p, touching_m)) {
        add(p, own, e, 1, in_kink(own, e, p, touching_m));
      }
    }
  }
  return contacts;
}

}  // namespace blockweir::solid::limit
