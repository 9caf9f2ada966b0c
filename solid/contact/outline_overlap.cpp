// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/outline_overlap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "solid/contact/outline.hpp"

namespace blockweir::solid {
namespace {

using Box = Eigen::AlignedBox2d;

struct Side {
  Point from;
  Point to;
};

/// Those that reach into the box.
std::vector<Side> sides_in(const Box& box, const std::vector<Point>& outline) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Side side{outline[i], outline[next(i, outline.size())]};
    Box around(side.from);
    if (around.extend(side.to).intersects(box)) sides.push_back(side);
  }
  return sides;
}

double distance_m(const std::vector<Point>& outline, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point span = outline[next(i, outline.size())] - outline[i];
    const double s = std::clamp(span.dot(p - outline[i]) / span.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (outline[i] + s * span - p).norm());
  }
  return least;
}

/// Does the line of one of a's sides part the two, but for so much? So it does where blocks lie on each other.
bool parted(const std::vector<Point>& a, const std::vector<Point>& b, double but_for_m) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point span = a[next(i, a.size())] - a[i];
    const double least = but_for_m / 2 * span.norm();
    const auto behind = [&](const Point& p) { return cross(p - a[i], span) < -least; };
    const auto before = [&](const Point& p) { return cross(p - a[i], span) > least; };
    if (std::none_of(b.begin(), b.end(), behind) && std::none_of(a.begin(), a.end(), before)) return true;
  }
  return false;
}

/// Fractions of a side at its ends and where others cross it, by size.
std::vector<double> pieces(const Side& side, const std::vector<Side>& others) {
  std::vector<double> at = {0, 1};
  const Point span = side.to - side.from;
  for (const Side& other : others) {
    const double from = cross(span, other.from - side.from);
    const double to = cross(span, other.to - side.from);
    if ((from > 0) == (to > 0)) continue;
    const Point crossing = other.from + from / (from - to) * (other.to - other.from);
    const double s = span.dot(crossing - side.from) / span.squaredNorm();
    if (s > 0 && s < 1) at.push_back(s);
  }
  std::sort(at.begin(), at.end());
  return at;
}

/// What two outlines' boxes have in common.
Box common_box(const std::vector<Point>& a, const std::vector<Point>& b) {
  const auto box_of = [](const std::vector<Point>& outline) {
    Box box;
    for (const Point& p : outline) box.extend(p);
    return box;
  };
  return box_of(a).intersection(box_of(b));
}

bool is_convex(const std::vector<Point>& outline) {
  constexpr double straight = 1e-9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point in = outline[i] - outline[previous(i, outline.size())];
    const Point out = outline[next(i, outline.size())] - outline[i];
    if (cross(in, out) < -straight * in.norm() * out.norm()) return false;
  }
  return true;
}

/// The least shift across one of a's sides that takes b off it, at most `most_m`; less than `known_m` is enough.
double shift_off_m(const std::vector<Point>& a, const std::vector<Point>& b, double most_m, double known_m) {
  for (std::size_t i = 0; i < a.size() && most_m > known_m; ++i) {
    const Point along = (a[next(i, a.size())] - a[i]).normalized();
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Point& p : b) deepest = std::max(deepest, cross(along, p - a[i]));
    most_m = std::min(most_m, deepest);
  }
  return most_m;
}

}  // namespace

double parting_shift_m(const std::vector<Point>& a, const std::vector<Point>& b, double known_m) {
  if (!is_convex(a) || !is_convex(b)) return overlap_m(a, b, known_m);
  const Box common = common_box(a, b);
  if (common.isEmpty() || common.sizes().minCoeff() <= known_m) return known_m;
  const double off_a_m = shift_off_m(a, b, std::numeric_limits<double>::infinity(), known_m);
  return std::max(known_m, shift_off_m(b, a, off_a_m, known_m));
}

double overlap_m(const std::vector<Point>& a, const std::vector<Point>& b, double known_m) {
  const Box common = common_box(a, b);
  double deepest = known_m;
  if (common.isEmpty() || common.sizes().minCoeff() <= deepest) return deepest;
  if (parted(a, b, known_m) || parted(b, a, known_m)) return deepest;
  const std::vector<Side> of_a = sides_in(common, a);
  const std::vector<Side> of_b = sides_in(common, b);
  const auto look = [&](const Point& p, const std::vector<Point>& other) {
    if (common.contains(p) && encloses(other, p)) deepest = std::max(deepest, distance_m(other, p));
  };
  for (const auto& [sides, across, other] : {std::tuple(&of_a, &of_b, &b), std::tuple(&of_b, &of_a, &a)}) {
    for (const Side& side : *sides) {
      look(side.from, *other);
      const std::vector<double> at = pieces(side, *across);
      if (at.size() == 2) continue;
      for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        look(side.from + (at[i] + at[i + 1]) / 2 * (side.to - side.from), *other);
      }
    }
  }
  return deepest;
}

}  // namespace blockweir::solid
