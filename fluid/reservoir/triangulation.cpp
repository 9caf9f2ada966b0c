// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace blockweir::reservoir {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using Face = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;

constexpr double outer_growth = 0.03;  // coarser meshes throw short waves back

Point from_cgal(const Kernel::Point_2& p) {
  return {p.x(), p.y()};
}

Kernel::Point_2 to_cgal(const Point& p) {
  return {p.x(), p.y()};
}

/// CGAL's criteria for a bad triangle: an angle below 20.7 degrees, or a side longer than it may be there.
class Criteria {
 public:
  using Face_handle = Triangulation::Face_handle;

  /// The worse the smaller: sides that are too long come first.
  struct Quality {
    double sine_squared = 1;
    double too_long = 0;  ///< longest side over the largest allowed, where above 1
    bool operator<(const Quality& q) const {
      if (too_long > 1 || q.too_long > 1) return too_long > q.too_long;
      return sine_squared < q.sine_squared;
    }
  };

  class Is_bad {
   public:
    explicit Is_bad(const Sizes& sizes) : sizes_(&sizes) {}
    [[nodiscard]] CGAL::Mesh_2::Face_badness operator()(const Quality& q) const {
      if (q.too_long > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return q.sine_squared < least_sine_squared ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const Face_handle& face, Quality& q) const {
      std::array<Point, 3> p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = from_cgal(face->vertex(static_cast<int>(i))->point());
      std::array<double, 3> side{(p[1] - p[0]).squaredNorm(), (p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm()};
      std::sort(side.begin(), side.end());
      const Point a = p[1] - p[0];
      const Point b = p[2] - p[0];
      const double twice_area = a.x() * b.y() - a.y() * b.x();
      q.sine_squared = twice_area * twice_area / (side[1] * side[2]);
      q.too_long = std::sqrt(side[2]) / sizes_->at((p[0] + p[1] + p[2]) / 3);
      return operator()(q);
    }

   private:
    static constexpr double least_sine_squared = 0.125;  // Shewchuk's bound, below which refinement ends
    const Sizes* sizes_;
  };

  explicit Criteria(const Sizes& sizes) : sizes_(&sizes) {}
  [[nodiscard]] Is_bad is_bad_object() const { return Is_bad(*sizes_); }

 private:
  const Sizes* sizes_;
};

}  // namespace

double Sizes::at(const Point& x) const {
  const double outside = std::max({0.0, inner_left_m - x.x(), x.x() - inner_right_m});
  if (outside > 0) return std::min(widest_m + outer_growth * outside, std::max(widest_m, outermost_m));
  double nearest = widest_m / growth * (widest_m / growth);  // squared: asked for each triangle, of all points
  for (const Point& p : points) nearest = std::min(nearest, (x - p).squaredNorm());
  return std::min(widest_m, at_point_m + growth * std::sqrt(nearest));
}

Triangulated triangulate(const std::vector<Ring>& rings, const Sizes& sizes) {
  Triangulation mesh;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& next = ring[(i + 1) % ring.size()];
      if (next != ring[i]) mesh.insert_constraint(to_cgal(ring[i]), to_cgal(next));
    }
  }
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(mesh, Criteria(sizes));
  mesher.refine_mesh();
  Triangulated result;
  std::map<Triangulation::Vertex_handle, int> number;
  for (const auto face : mesh.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    auto& corners = result.triangle.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto [entry, fresh] = number.try_emplace(face->vertex(i), static_cast<int>(result.node.size()));
      if (fresh) result.node.push_back(from_cgal(face->vertex(i)->point()));
      corners[static_cast<std::size_t>(i)] = entry->second;
    }
  }
  return result;
}

}  // namespace blockweir::reservoir
