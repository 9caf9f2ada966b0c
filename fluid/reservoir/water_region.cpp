// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/water_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

using geometry::cross;
using hydrostatic::WaterBody;

constexpr double same_place = 1e-7;  ///< of the depth

/// Without the points that clipping leaves twice or on straight lines.
Ring corners_of(const Ring& ring, double tiny_m) {
  Ring apart;
  for (const Point& p : ring) {
    if (apart.empty() || (p - apart.back()).norm() > tiny_m) apart.push_back(p);
  }
  while (apart.size() > 1 && (apart.front() - apart.back()).norm() <= tiny_m) apart.pop_back();
  Ring corners;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const Point& before = corners.empty() ? apart.back() : corners.back();
    const Point through = apart[(i + 1) % apart.size()] - before;
    if (std::abs(cross(through, apart[i] - before)) > tiny_m * through.norm()) corners.push_back(apart[i]);
  }
  return corners;
}

/// Grown by `most` of the grid's units, below zero: shrunk; then back.
ClipperLib::Paths there_and_back(const ClipperLib::Paths& paths, double most) {
  ClipperLib::Paths result = paths;
  for (const double by : {most, -most}) {
    ClipperLib::ClipperOffset offset;
    offset.AddPaths(result, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    offset.Execute(result, by);
  }
  return result;
}

}  // namespace

Extent extent_of(const std::vector<Ring>& rings) {
  Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Ring& ring : rings) {
    for (const Point& p : ring) extent = {std::min(extent.left_m, p.x()), std::max(extent.right_m, p.x())};
  }
  return extent;
}

double depth(const WaterBody& body) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Ring& ring : body.wet->region) {
    for (const Point& p : ring) lowest = std::min(lowest, p.y());
  }
  return std::max(0.0, body.surface.from_m.y() - lowest);
}

double same_place_m(const WaterBody& body) {
  return same_place * depth(body);
}

std::vector<Point> ends_of_faces(const WaterBody& body, const Banks& banks) {
  std::vector<Point> ends;
  for (const hydrostatic::WetInterval& wet : body.wet->intervals) {
    const auto& outline = banks.outlines[at(wet.block)];
    const Point& from = outline[at(wet.edge)];
    const Point span = outline[(at(wet.edge) + 1) % outline.size()] - from;
    ends.insert(ends.end(), {from + wet.s_from * span, from + wet.s_to * span});
  }
  return ends;
}

Ring with_points(const Ring& ring, const std::vector<Point>& points, double tiny_m) {
  Ring all;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    all.push_back(ring[i]);
    const Point span = ring[(i + 1) % ring.size()] - ring[i];
    const double length = span.norm();
    std::vector<double> on;
    for (const Point& p : points) {
      const double along = span.dot(p - ring[i]) / length;
      if (std::abs(cross(span, p - ring[i])) > tiny_m * length || along < tiny_m || along > length - tiny_m) continue;
      on.push_back(along);
    }
    std::sort(on.begin(), on.end());
    double last = -1;
    for (const double along : on) {
      if (along - last > tiny_m) all.push_back(ring[i] + along / length * span);
      last = along;
    }
  }
  return all;
}

std::vector<Ring> without_crossings(const std::vector<Ring>& rings, const WaterBody& body, double width_m) {
  hydrostatic::Extent reach;
  for (const Ring& ring : rings) {
    for (const Point& p : ring) reach.extend(p);
  }
  const hydrostatic::Grid grid(reach);
  ClipperLib::Clipper clipper;
  for (const Ring& ring : rings) clipper.AddPath(grid.units(ring), ClipperLib::ptSubject, true);
  ClipperLib::Paths water;
  clipper.Execute(ClipperLib::ctUnion, water, ClipperLib::pftPositive, ClipperLib::pftPositive);
  const double width = width_m * grid.per_m;
  water = there_and_back(there_and_back(water, width), -width);
  std::vector<Ring> apart;
  const auto add = [&](const ClipperLib::Path& path) {
    Ring ring;
    for (const ClipperLib::IntPoint& p : path) ring.push_back(grid.metres(p));
    ring = corners_of(ring, same_place_m(body));
    if (ring.size() > 2) apart.push_back(std::move(ring));
  };
  const double surface_m = body.surface.from_m.y() - width_m;
  for (const ClipperLib::Path& outer : water) {
    const auto is_up = [&](const ClipperLib::IntPoint& p) { return grid.metres(p).y() > surface_m; };
    if (!ClipperLib::Orientation(outer) || std::none_of(outer.begin(), outer.end(), is_up)) continue;
    add(outer);
    for (const ClipperLib::Path& hole : water) {
      if (!ClipperLib::Orientation(hole) && ClipperLib::PointInPolygon(hole.front(), outer) != 0) add(hole);
    }
  }
  return apart;
}

std::vector<Ring> region_of(const WaterBody& body, const Banks& banks, const FarEnds& far) {
  const double tiny_m = same_place_m(body);
  const Extent water = extent_of(body.wet->region);
  const Extent blocks = extent_of(banks.outlines);
  const double left_m = std::min(far.left.x_m, blocks.left_m);
  const double right_m = std::max(far.right.x_m, blocks.right_m);
  std::vector<Ring> rings;
  for (const Ring& given : body.wet->region) {
    Ring ring = given;
    for (Point& p : ring) {
      if (water.left_m < blocks.left_m - tiny_m && p.x() < std::max(water.left_m + tiny_m, left_m)) p.x() = left_m;
      if (water.right_m > blocks.right_m + tiny_m && p.x() > std::min(water.right_m - tiny_m, right_m)) p.x() = right_m;
    }
    Ring corners = corners_of(ring, tiny_m);
    if (corners.size() > 2) rings.push_back(std::move(corners));
  }
  return rings;
}

}  // namespace blockweir::reservoir
