// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of blocks: faults of an outline, and points on or inside it.
#include "bridge/geometry/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace blockweir::geometry {
namespace {

Segment edge(std::span<const Point> outline, std::size_t i) {
  return {outline[i], outline[(i + 1) % outline.size()]};
}

/// Where two segments meet, ends included, within `tolerance`.
std::optional<Point> meeting(const Segment& p, const Segment& q, double tolerance) {
  for (const Point& end : {p.from, p.to}) {
    if (distance_to_segment(end, q.from, q.to) <= tolerance) return end;
  }
  for (const Point& end : {q.from, q.to}) {
    if (distance_to_segment(end, p.from, p.to) <= tolerance) return end;
  }
  const Point along_p = p.to - p.from;
  const Point along_q = q.to - q.from;
  const double turn = cross(along_p, along_q);
  if (turn == 0) return std::nullopt;
  const double s = cross(q.from - p.from, along_q) / turn;
  const double t = cross(q.from - p.from, along_p) / turn;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return Point(p.from + s * along_p);
}

/// Coordinates have 16 digits: an outline far from the origin must keep enough of them for its own shape.
std::optional<OutlineFault> lost_in_round_off(const Bounds& bounds) {
  const double farthest = std::max(bounds.low.cwiseAbs().maxCoeff(), bounds.high.cwiseAbs().maxCoeff());
  if (bounds.size() >= std::max(1e-6, 1e-7 * farthest)) return std::nullopt;
  return OutlineFault{0, fmt::format("is {:.3g} m wide, {:.3g} m from the origin", bounds.size(), farthest),
                      "at least 1e-6 m, and 1e-7 of the distance from the origin",
                      "check the unit of its coordinates, or move the origin nearer"};
}

std::optional<OutlineFault> repeated_vertex(std::span<const Point> outline, double tolerance) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    if ((outline[i] - outline[next]).norm() > tolerance) continue;
    return OutlineFault{std::max(i, next), fmt::format("has the vertex ({}, {}) twice", outline[i].x(), outline[i].y()),
                        "vertices that differ from their neighbours",
                        "leave one of them out; the outline closes by itself"};
  }
  return std::nullopt;
}

bool all_on_a_line(std::span<const Point> outline, double tolerance) {
  const Point& a = outline[0];
  const Point& b = *std::max_element(outline.begin(), outline.end(), [&](const Point& p, const Point& q) {
    return (p - a).squaredNorm() < (q - a).squaredNorm();
  });
  return std::all_of(outline.begin(), outline.end(),
                     [&](const Point& p) { return std::abs(cross((b - a).normalized(), p - a)) <= tolerance; });
}

/// An edge that runs back over the one before it.
std::optional<Point> spike(std::span<const Point> outline, double tolerance) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Segment before = edge(outline, i);
    const Segment after = edge(outline, (i + 1) % outline.size());
    if ((before.to - before.from).dot(after.to - after.from) >= 0) continue;
    const bool returns = distance_to_segment(after.to, before.from, before.to) <= tolerance ||
                         distance_to_segment(before.from, after.from, after.to) <= tolerance;
    if (returns) return before.to;
  }
  return std::nullopt;
}

struct Crossing {
  std::size_t first;
  std::size_t second;
  Point at;
};

/// Two edges, not neighbours, that meet; sweeps from left to right.
std::optional<Crossing> crossing(std::span<const Point> outline, double tolerance) {
  const std::size_t n = outline.size();
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < n; ++i) boxes.push_back(bounds_of(std::array{outline[i], outline[(i + 1) % n]}));
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return boxes[a].low.x() < boxes[b].low.x(); });
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = order[k];
    for (std::size_t l = k + 1; l < n && boxes[order[l]].low.x() <= boxes[i].high.x() + tolerance; ++l) {
      const std::size_t j = order[l];
      const bool neighbours = (i + 1) % n == j || (j + 1) % n == i;
      const bool apart =
          boxes[i].low.y() > boxes[j].high.y() + tolerance || boxes[j].low.y() > boxes[i].high.y() + tolerance;
      if (neighbours || apart) continue;
      if (const auto at = meeting(edge(outline, i), edge(outline, j), tolerance)) {
        return Crossing{std::min(i, j), std::max(i, j), *at};
      }
    }
  }
  return std::nullopt;
}

std::string edge_text(std::span<const Point> outline, std::size_t i) {
  const Segment e = edge(outline, i);
  return fmt::format("({}, {}) to ({}, {})", e.from.x(), e.from.y(), e.to.x(), e.to.y());
}

}  // namespace

Bounds bounds_of(std::span<const Point> points) {
  Bounds bounds{points[0], points[0]};
  for (const Point& p : points) {
    bounds.low = bounds.low.cwiseMin(p);
    bounds.high = bounds.high.cwiseMax(p);
  }
  return bounds;
}

Point nearest_on_segment(const Point& p, const Point& from, const Point& to) {
  const Point span = to - from;
  const double squared = span.squaredNorm();
  const double s = squared > 0 ? std::clamp(span.dot(p - from) / squared, 0.0, 1.0) : 0.0;
  return from + s * span;
}

double distance_to_segment(const Point& p, const Point& from, const Point& to) {
  return (nearest_on_segment(p, from, to) - p).norm();
}

std::optional<OutlineFault> outline_fault(std::span<const Point> outline) {
  const Bounds bounds = bounds_of(outline);
  const double tolerance = 1e-9 * bounds.size();
  if (auto fault = lost_in_round_off(bounds)) return fault;
  if (auto fault = repeated_vertex(outline, tolerance)) return fault;
  if (all_on_a_line(outline, tolerance)) {
    return OutlineFault{0, "has no area", "an outline around an area", "move a vertex off the line of the others"};
  }
  if (const auto tip = spike(outline, tolerance)) {
    return OutlineFault{0, fmt::format("doubles back on itself at ({}, {})", tip->x(), tip->y()),
                        "edges that meet at their common vertices only", "leave that vertex out"};
  }
  if (const auto c = crossing(outline, tolerance)) {
    return OutlineFault{c->first,
                        fmt::format("crosses itself at ({:.6g}, {:.6g}), where its edges {} and {} meet", c->at.x(),
                                    c->at.y(), edge_text(outline, c->first), edge_text(outline, c->second)),
                        "edges that meet at their common vertices only", "put the vertices in order along the outline"};
  }
  return std::nullopt;
}

bool holds_point(std::span<const Point> outline, const Point& p, double tolerance_m) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto [a, b] = edge(outline, i);
    if (distance_to_segment(p, a, b) <= tolerance_m) return true;
    const bool passes = (a.y() > p.y()) != (b.y() > p.y());
    if (passes && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

bool on_one_edge(std::span<const Point> outline, const Point& p, const Point& q, double tolerance_m) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto [a, b] = edge(outline, i);
    if (distance_to_segment(p, a, b) <= tolerance_m && distance_to_segment(q, a, b) <= tolerance_m) return true;
  }
  return false;
}

}  // namespace blockweir::geometry
