// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/reservoir_mesh.hpp"

// Before the headers of CGAL.
#include "bridge/geometry/ascending_memory.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <deque>

#include "bridge/geometry/box_index.hpp"
#include "bridge/geometry/polygon.hpp"

namespace blockweir::hydrostatic {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::Exact_predicates_tag>;

constexpr double same_point = 1e-3;  // of the distance at which interface and boundary are one

Kernel::Point_2 to_cgal(const Point& p) {
  return {p.x(), p.y()};
}

Point from_cgal(const Kernel::Point_2& p) {
  return {p.x(), p.y()};
}

/// A boundary segment of the region as a chain of nodes: those of the interface where there are any, else pieces of
/// about `size_m`.
class BoundaryChains {
 public:
  BoundaryChains(const std::vector<InterfaceElement>& interface, double size_m, double near_m)
      : size_(size_m), near_(near_m), nodes_(nodes_of(interface)), index_(nodes_) {}

  [[nodiscard]] std::vector<Point> chain(const Point& a, const Point& b) const {
    const double length = (b - a).norm();
    const Point t = (b - a) / length;
    std::vector<std::pair<double, Point>> on;  // by distance from a
    for (const Point& node : near(a, b)) {
      const double s = t.dot(node - a);
      const double away = std::abs(t.x() * (node - a).y() - t.y() * (node - a).x());
      if (away <= near_ && s > -near_ && s < length + near_) on.emplace_back(s, node);
    }
    std::sort(on.begin(), on.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    std::vector<Point> points;
    if (on.empty() || on.front().first > near_) points.push_back(a);
    bool last_on_interface = false;
    for (const auto& [s, node] : on) {
      if (!points.empty() && (node - points.back()).norm() < same_point * near_) continue;
      if (!points.empty() && !last_on_interface) add_pieces(points, node);
      points.push_back(node);
      last_on_interface = true;
    }
    if (on.empty() || on.back().first < length - near_) {
      add_pieces(points, b);
      points.push_back(b);
    }
    return points;
  }

 private:
  static std::vector<Point> nodes_of(const std::vector<InterfaceElement>& interface) {
    std::vector<Point> nodes;
    for (const InterfaceElement& element : interface) nodes.insert(nodes.end(), element.begin(), element.end());
    return nodes;
  }
  [[nodiscard]] std::vector<Point> near(const Point& a, const Point& b) const {
    const Point margin(near_, near_);
    std::vector<Point> points;
    for (const std::size_t i : index_.meeting({a.cwiseMin(b) - margin, a.cwiseMax(b) + margin})) {
      points.push_back(nodes_[i]);
    }
    return points;
  }
  /// The points strictly between the chain's last one and `to`.
  void add_pieces(std::vector<Point>& points, const Point& to) const {
    const Point from = points.back();
    const auto n = static_cast<int>(std::ceil((to - from).norm() / size_ - 1e-9));
    for (int i = 1; i < n; ++i) points.push_back(from + (to - from) * i / n);
  }

  double size_;
  double near_;
  std::vector<Point> nodes_;
  geometry::BoxIndex index_;
};

/// Clipping leaves duplicate corners and corners on straight lines; they must not split an interface element.
Ring without_straight_corners(Ring ring, double straight_m) {
  const auto same = [&](const Point& p, const Point& q) { return (p - q).norm() < straight_m; };
  ring.erase(std::unique(ring.begin(), ring.end(), same), ring.end());
  while (ring.size() > 1 && same(ring.front(), ring.back())) ring.pop_back();
  Ring corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& before = corners.empty() ? ring.back() : corners.back();
    const Point in = ring[i] - before;
    const Point through = ring[(i + 1) % ring.size()] - before;
    const double away = std::abs(through.x() * in.y() - through.y() * in.x());
    if (away > straight_m * through.norm()) corners.push_back(ring[i]);
  }
  return corners;
}

/// Numbers faces by the constraints between them and the outside: odd ones lie in the region.
void mark_inside(Triangulation& mesh) {
  for (const auto face : mesh.all_face_handles()) face->info() = -1;
  std::deque<std::pair<Triangulation::Face_handle, int>> border{{mesh.infinite_face(), 0}};
  while (!border.empty()) {
    const auto [face, depth] = border.front();
    border.pop_front();
    if (face->info() >= 0) continue;
    face->info() = depth;
    for (int side = 0; side < 3; ++side) {
      // Faces of one depth come before those behind the next constraint.
      if (mesh.is_constrained({face, side})) {
        border.emplace_back(face->neighbor(side), depth + 1);
      } else {
        border.emplace_front(face->neighbor(side), depth);
      }
    }
  }
}

bool inside(Triangulation::Face_handle face) {
  return face->info() % 2 == 1;
}

/// Nodes of a lattice of equilateral triangles that lie in the region and not too near its boundary.
std::vector<Kernel::Point_2> lattice(const Triangulation& boundary, const geometry::BoxIndex& boundary_nodes,
                                     const geometry::Bounds& extent, double size_m) {
  std::vector<Kernel::Point_2> points;
  const double row_height = size_m * std::sqrt(3.0) / 2;
  Triangulation::Face_handle hint;
  int row = 0;
  for (double y = extent.low.y() + row_height / 2; y < extent.high.y(); y += row_height, ++row) {
    for (double x = extent.low.x() + size_m * (row % 2 == 0 ? 0.5 : 1); x < extent.high.x(); x += size_m) {
      hint = boundary.locate({x, y}, hint);
      if (boundary.is_infinite(hint) || !inside(hint)) continue;
      const double keep = 0.6 * size_m;
      if (boundary_nodes.any_meets({{x - keep, y - keep}, {x + keep, y + keep}})) continue;
      points.emplace_back(x, y);
    }
  }
  return points;
}

geometry::Bounds bounds_of(const std::vector<Ring>& region) {
  Ring points;
  for (const Ring& ring : region) points.insert(points.end(), ring.begin(), ring.end());
  return geometry::bounds_of(points);
}

ReservoirMesh extract(Triangulation& mesh) {
  ReservoirMesh result;
  constexpr auto unused = static_cast<std::size_t>(-1);
  for (const auto vertex : mesh.finite_vertex_handles()) vertex->info() = unused;
  for (const auto face : mesh.finite_face_handles()) {
    if (!inside(face)) continue;
    std::array<std::size_t, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const auto vertex = face->vertex(i);
      if (vertex->info() == unused) {
        vertex->info() = result.node.size();
        result.node.push_back(from_cgal(vertex->point()));
      }
      corners[static_cast<std::size_t>(i)] = vertex->info();
    }
    result.triangle.push_back(corners);
  }
  return result;
}

}  // namespace

ReservoirMesh mesh_reservoir(const std::vector<Ring>& region, const std::vector<InterfaceElement>& interface,
                             double size_m, double near_m) {
  double area = 0;
  for (const Ring& ring : region) area += geometry::signed_area(ring);
  if (area <= 0) return {};
  constexpr double most_nodes = 50000;
  const double size = std::max(size_m, std::sqrt(area / most_nodes));

  Triangulation mesh;
  Ring boundary_nodes;
  const BoundaryChains chains(interface, size, near_m);
  for (const Ring& given : region) {
    const Ring ring = without_straight_corners(given, same_point * near_m);
    std::vector<Point> nodes;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (const Point& p : chains.chain(ring[i], ring[(i + 1) % ring.size()])) {
        if (nodes.empty() || nodes.back() != p) nodes.push_back(p);
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Point& next = nodes[(i + 1) % nodes.size()];
      if (next != nodes[i]) mesh.insert_constraint(to_cgal(nodes[i]), to_cgal(next));
      boundary_nodes.push_back(next);
    }
  }
  mark_inside(mesh);
  const auto points = lattice(mesh, geometry::BoxIndex(boundary_nodes), bounds_of(region), size);
  mesh.insert(points.begin(), points.end());
  mark_inside(mesh);
  return extract(mesh);
}

}  // namespace blockweir::hydrostatic
