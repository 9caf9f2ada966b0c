// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/mesh.hpp"

// Before the headers of CGAL.
#include "bridge/geometry/ascending_memory.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/lloyd_optimize_mesh_2.h>

#include <cmath>
#include <map>

namespace blockweir::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Delaunay_mesh_vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;

/// The outline's edges in even pieces no longer than `size_m`.
void insert_outline(Triangulation& mesh, const std::vector<Point>& outline, double size_m) {
  const auto vertex = [&](const Point& p) { return mesh.insert(Kernel::Point_2(p.x(), p.y())); };
  for (std::size_t e = 0; e < outline.size(); ++e) {
    const Point& a = outline[e];
    const Point& b = outline[(e + 1) % outline.size()];
    const auto pieces = static_cast<int>(std::ceil((b - a).norm() / size_m - 1e-9));
    auto last = vertex(a);
    for (int i = 1; i < pieces; ++i) {
      const auto next = vertex(a + (b - a) * i / pieces);
      mesh.insert_constraint(last, next);
      last = next;
    }
    mesh.insert_constraint(last, vertex(b));
  }
}

Mesh extract(const Triangulation& triangulation) {
  Mesh mesh;
  for (const auto vertex : triangulation.finite_vertex_handles()) vertex->info() = -1;
  for (const auto face : triangulation.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    auto& triangle = mesh.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto vertex = face->vertex(i);
      if (vertex->info() < 0) {
        vertex->info() = static_cast<int>(mesh.nodes.size());
        mesh.nodes.emplace_back(vertex->point().x(), vertex->point().y());
      }
      triangle[static_cast<std::size_t>(i)] = vertex->info();
    }
  }
  return mesh;
}

/// Sides that no other triangle shares, chained from the outline's first vertex on.
void follow_boundary(Mesh& mesh, const std::vector<Point>& outline) {
  std::map<std::pair<int, int>, std::pair<int, int>> sides;  // (from node, to node): triangle, side
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides[{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]}] = {static_cast<int>(t), static_cast<int>(i)};
    }
  }
  std::map<int, std::pair<int, std::pair<int, int>>> next;  // from node: to node, triangle, side
  for (const auto& [nodes, side] : sides) {
    if (sides.count({nodes.second, nodes.first}) == 0) next[nodes.first] = {nodes.second, side};
  }
  const auto place = [&](int node) -> const Point& { return mesh.nodes[static_cast<std::size_t>(node)]; };
  int node = -1;
  for (const auto& [from, to] : next) node = place(from) == outline[0] ? from : node;
  double along = 0;
  for (std::size_t e = 0; e < outline.size() && mesh.boundary.size() < next.size();) {
    const Point& end = outline[(e + 1) % outline.size()];
    const double length = (end - outline[e]).norm();
    const auto& [to, side] = next.at(node);
    const bool last = place(to) == end;
    const double reached = last ? 1 : (place(to) - outline[e]).norm() / length;
    mesh.boundary.push_back({side.first, side.second, static_cast<int>(e), along, reached});
    along = last ? 0 : reached;
    if (last) ++e;
    node = to;
  }
}

}  // namespace

Mesh triangulate(const std::vector<Point>& outline, double size_m) {
  constexpr double shape_bound = 0.125;  // the squared sine of 20.7 degrees, below which refinement is sure to end
  Triangulation triangulation;
  insert_outline(triangulation, outline, size_m);
  CGAL::refine_Delaunay_mesh_2(triangulation, Criteria(shape_bound, size_m));
  CGAL::lloyd_optimize_mesh_2(triangulation, CGAL::parameters::max_iteration_number = 20);
  Mesh mesh = extract(triangulation);
  follow_boundary(mesh, outline);
  return mesh;
}

}  // namespace blockweir::geometry
