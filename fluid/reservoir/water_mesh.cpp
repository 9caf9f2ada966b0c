// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/water_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "fluid/reservoir/triangulation.hpp"
#include "fluid/reservoir/water_region.hpp"

namespace blockweir::reservoir {
namespace {

using geometry::cross;
using hydrostatic::WaterBody;

constexpr double outermost =
    0.6;  ///< of the depth: triangles of the absorbing stretch; with 1.0, 1.1 % of sound came back

/// Finds the face of a block that a side of the mesh lies on.
class Faces {
 public:
  Faces(const WaterBody& body, const std::vector<std::vector<Point>>& outlines, double tiny_m) : tiny_m_(tiny_m) {
    for (const hydrostatic::WetInterval& wet : body.wet->intervals) {
      const auto& outline = outlines[at(wet.block)];
      const Point& from = outline[at(wet.edge)];
      faces_.push_back({&wet, from, outline[(at(wet.edge) + 1) % outline.size()] - from});
    }
  }

  /// Fills in block, edge and fractions; false where no wet face is that near.
  bool find(const Point& from, const Point& to, BoundarySide& side) const {
    const Point middle = (from + to) / 2;
    for (const Face& face : faces_) {
      const double length = face.span.norm();
      if (std::abs(cross(face.span, middle - face.from)) > tiny_m_ * length) continue;
      const auto along = [&](const Point& p) { return face.span.dot(p - face.from) / (length * length); };
      const double s = along(middle);
      if (s < face.wet->s_from || s > face.wet->s_to) continue;
      side.block = face.wet->block;
      side.edge = face.wet->edge;
      side.s_from = std::clamp(along(from), 0.0, 1.0);
      side.s_to = std::clamp(along(to), 0.0, 1.0);
      return true;
    }
    return false;
  }

 private:
  struct Face {
    const hydrostatic::WetInterval* wet;
    Point from;
    Point span;
  };
  std::vector<Face> faces_;
  double tiny_m_;
};

/// Gives each side of a triangle its middle node, and finds those that belong to one triangle alone.
class MiddleNodes {
 public:
  explicit MiddleNodes(WaterMesh& mesh) : mesh_(mesh) {}

  int between(int a, int b) {
    const auto [entry, fresh] = middle_.try_emplace(std::minmax(a, b), Side{static_cast<int>(mesh_.node.size()), a, b});
    if (fresh) {
      mesh_.node.push_back((mesh_.node[at(a)] + mesh_.node[at(b)]) / 2);
    } else {
      entry->second.shared = true;
    }
    return entry->second.middle;
  }

  void add_boundary() const {
    for (const auto& [ends, side] : middle_) {
      if (side.shared) continue;
      mesh_.side.emplace_back().node = {side.from, side.middle, side.to};
    }
  }

 private:
  struct Side {
    int middle;
    int from;
    int to;
    bool shared = false;
  };
  WaterMesh& mesh_;
  std::map<std::pair<int, int>, Side> middle_;
};

Sizes sizes_of(const std::vector<Ring>& rings, const WaterBody& body, const Banks& banks, const FarEnds& ends,
               const Fineness& fineness) {
  const double deep = depth(body);
  const double tiny = same_place_m(body);
  const Extent blocks = extent_of(banks.outlines);
  Sizes sizes{{}, fineness.at_corner * deep, fineness.widest * deep, fineness.growth};
  if (ends.left.absorbs_from_m) sizes.inner_left_m = *ends.left.absorbs_from_m;
  if (ends.right.absorbs_from_m) sizes.inner_right_m = *ends.right.absorbs_from_m;
  sizes.outermost_m = outermost * deep;
  for (const Ring& ring : rings) {
    for (const Point& p : ring) {
      if (p.x() > blocks.left_m - tiny && p.x() < blocks.right_m + tiny) sizes.points.push_back(p);
    }
  }
  return sizes;
}

/// Where sides lie on each other, as of a crack that has closed again, what lies beyond one may be water: then all of
/// it has no triangles.
bool fills(const Triangulated& triangles, const std::vector<Ring>& rings) {
  constexpr double part = 0.999;
  double region = 0;
  for (const Ring& ring : rings) region += geometry::signed_area(ring);
  double area = 0;
  for (const auto& [a, b, c] : triangles.triangle) {
    area +=
        std::abs(cross(triangles.node[at(b)] - triangles.node[at(a)], triangles.node[at(c)] - triangles.node[at(a)]));
  }
  return area / 2 >= part * region;
}

/// Triangles of a body's region, which becomes the rings that they fill.
Triangulated triangulate(std::vector<Ring>& region, const WaterBody& body, const Banks& banks, const FarEnds& ends,
                         const Fineness& fineness) {
  const double tiny = same_place_m(body);
  const std::vector<Point> ends_on_faces = ends_of_faces(body, banks);
  for (const double narrow : {0.0, 1e-6, 1e-5, 1e-4}) {  // of the depth
    std::vector<Ring> rings = narrow == 0 ? region : without_crossings(region, body, narrow * depth(body));
    for (Ring& ring : rings) ring = with_points(ring, ends_on_faces, 10 * tiny);
    const Sizes sizes = sizes_of(rings, body, banks, ends, fineness);
    for (Ring& ring : rings) ring = with_points(ring, banks.corners, 10 * tiny);
    std::optional<Triangulated> triangles = triangulate(rings, sizes);
    if (!triangles || !fills(*triangles, rings)) continue;
    region = std::move(rings);
    return *std::move(triangles);
  }
  throw std::runtime_error(fmt::format(
      "the reservoir at level {:.6g} m has no mesh: its boundary crosses itself where blocks part or close; expected "
      "banks apart; state a larger open_crack_width_m in [water], or stop_at_failure = true in [analysis]",
      body.surface.from_m.y()));
}

}  // namespace

WaterMesh mesh_water(const WaterBody& body, const Banks& banks, const FarEnds& ends, const Fineness& fineness) {
  const auto& outlines = banks.outlines;
  WaterMesh mesh;
  const double deep = depth(body);
  mesh.ends = ends;
  mesh.depth_m = deep;
  if (deep <= 0) return mesh;
  const double tiny = same_place_m(body);
  std::vector<Ring> rings = region_of(body, banks, ends);
  if (rings.empty()) return mesh;
  const Extent open = extent_of(rings);
  const Extent blocks = extent_of(outlines);
  Triangulated triangles = triangulate(rings, body, banks, ends, fineness);
  mesh.rings = std::move(rings);
  mesh.node = std::move(triangles.node);
  MiddleNodes middles(mesh);
  for (const auto& [a, b, c] : triangles.triangle) {
    mesh.triangle.push_back({a, b, c, middles.between(a, b), middles.between(b, c), middles.between(c, a)});
  }
  middles.add_boundary();
  const Faces faces(body, outlines, 10 * tiny);
  const double level = body.surface.from_m.y();
  for (BoundarySide& side : mesh.side) {
    const Point& from = mesh.node[at(side.node[0])];
    const Point& to = mesh.node[at(side.node[2])];
    const Point middle = mesh.node[at(side.node[1])];
    const auto stands_at = [&](double x) { return std::abs(from.x() - x) < tiny && std::abs(to.x() - x) < tiny; };
    if (std::abs(from.y() - level) < 2 * tiny && std::abs(to.y() - level) < 2 * tiny) {
      side.kind = BoundarySide::Kind::surface;
    } else if (faces.find(from, to, side)) {
      side.kind = BoundarySide::Kind::face;
    } else if ((stands_at(open.left_m) && middle.x() < blocks.left_m + tiny && !ends.left.wall) ||
               (stands_at(open.right_m) && middle.x() > blocks.right_m - tiny && !ends.right.wall)) {
      side.kind = BoundarySide::Kind::far_end;
    }
  }
  return mesh;
}

}  // namespace blockweir::reservoir
