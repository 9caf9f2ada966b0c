// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/water_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "bridge/scene/at.hpp"
#include "fluid/reservoir/triangulation.hpp"

namespace blockweir::reservoir {
namespace {

using hydrostatic::WaterBody;

constexpr double same_place = 1e-7;  ///< of the depth
constexpr double outermost = 0.6;    ///< of it: triangles of the absorbing stretch; with 1.0, 1.1 % of sound came back

struct Ends {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
};

Ends ends_of(const std::vector<Ring>& rings) {
  Ends ends;
  for (const Ring& ring : rings) {
    for (const Point& p : ring) ends = {std::min(ends.left, p.x()), std::max(ends.right, p.x())};
  }
  return ends;
}

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

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

/// Where wet faces begin and end: what one block does to the water stops there.
std::vector<Point> ends_of_faces(const WaterBody& body, const std::vector<std::vector<Point>>& outlines) {
  std::vector<Point> ends;
  for (const hydrostatic::WetInterval& wet : body.wet->intervals) {
    const auto& outline = outlines[at(wet.block)];
    const Point& from = outline[at(wet.edge)];
    const Point span = outline[(at(wet.edge) + 1) % outline.size()] - from;
    ends.insert(ends.end(), {from + wet.s_from * span, from + wet.s_to * span});
  }
  return ends;
}

/// The ring with those of `points` that lie on its sides.
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

/// The body's region in corners, its ends in open water moved to the far ends. A wall may stand on the blocks' own end:
/// what water there is beyond ends at it.
std::vector<Ring> region_of(const WaterBody& body, const std::vector<std::vector<Point>>& outlines, const FarEnds& far,
                            double tiny_m) {
  const Ends water = ends_of(body.wet->region);
  const Ends blocks = ends_of(outlines);
  const double left_m = std::min(far.left.x_m, blocks.left);
  const double right_m = std::max(far.right.x_m, blocks.right);
  const std::vector<Point> ends = ends_of_faces(body, outlines);
  std::vector<Ring> rings;
  for (const Ring& given : body.wet->region) {
    Ring ring = given;
    for (Point& p : ring) {
      if (water.left < blocks.left - tiny_m && p.x() < std::max(water.left + tiny_m, left_m)) p.x() = left_m;
      if (water.right > blocks.right + tiny_m && p.x() > std::min(water.right - tiny_m, right_m)) p.x() = right_m;
    }
    const Ring corners = corners_of(ring, tiny_m);
    if (corners.size() > 2) rings.push_back(with_points(corners, ends, 10 * tiny_m));
  }
  return rings;
}

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

}  // namespace

double depth(const WaterBody& body) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Ring& ring : body.wet->region) {
    for (const Point& p : ring) lowest = std::min(lowest, p.y());
  }
  return std::max(0.0, body.surface.from_m.y() - lowest);
}

WaterMesh mesh_water(const WaterBody& body, const Banks& banks, const FarEnds& ends, const Fineness& fineness) {
  const auto& outlines = banks.outlines;
  WaterMesh mesh;
  const double deep = depth(body);
  mesh.ends = ends;
  mesh.depth_m = deep;
  if (deep <= 0) return mesh;
  const double tiny = same_place * deep;
  std::vector<Ring> rings = region_of(body, outlines, ends, tiny);
  if (rings.empty()) return mesh;
  const Ends open = ends_of(rings);
  const Ends blocks = ends_of(outlines);
  Sizes sizes{{}, fineness.at_corner * deep, fineness.widest * deep, fineness.growth};
  if (ends.left.absorbs_from_m) sizes.inner_left_m = *ends.left.absorbs_from_m;
  if (ends.right.absorbs_from_m) sizes.inner_right_m = *ends.right.absorbs_from_m;
  sizes.outermost_m = outermost * deep;
  for (const Ring& ring : rings) {
    for (const Point& p : ring) {
      if (p.x() > blocks.left - tiny && p.x() < blocks.right + tiny) sizes.points.push_back(p);
    }
  }
  for (Ring& ring : rings) ring = with_points(ring, banks.corners, 10 * tiny);
  Triangulated triangles = triangulate(rings, sizes);
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
    } else if ((stands_at(open.left) && middle.x() < blocks.left + tiny && !ends.left.wall) ||
               (stands_at(open.right) && middle.x() > blocks.right - tiny && !ends.right.wall)) {
      side.kind = BoundarySide::Kind::far_end;
    }
  }
  return mesh;
}

}  // namespace blockweir::reservoir
