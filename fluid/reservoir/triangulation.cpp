// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/triangulation.hpp"

// Before the headers of CGAL.
#include "bridge/geometry/ascending_memory.hpp"

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

/// The size that Sizes allows at a place. CGAL asks for it for each triangle that it makes: the points are in order
/// along the axis on which they lie farther apart, and those beyond the nearest found are not looked at.
class SizeField {
 public:
  explicit SizeField(const Sizes& sizes) : sizes_(sizes) {
    Eigen::AlignedBox2d reach;
    for (const Point& p : sizes.points) reach.extend(p);
    if (!reach.isEmpty() && reach.sizes().y() > reach.sizes().x()) axis_ = 1;
    std::sort(sizes_.points.begin(), sizes_.points.end(),
              [this](const Point& a, const Point& b) { return a[axis_] < b[axis_]; });
  }

  /// No side may be shorter at any place.
  [[nodiscard]] double least_m() const { return std::min(sizes_.at_point_m, sizes_.widest_m); }

  [[nodiscard]] double at(const Point& x) const {
    const double outside = std::max({0.0, sizes_.inner_left_m - x.x(), x.x() - sizes_.inner_right_m});
    if (outside > 0) {
      return std::min(sizes_.widest_m + outer_growth * outside, std::max(sizes_.widest_m, sizes_.outermost_m));
    }
    return std::min(sizes_.widest_m, sizes_.at_point_m + sizes_.growth * std::sqrt(nearest_squared(x)));
  }

 private:
  /// Distance from the nearest point, or that from which on it does not count.
  [[nodiscard]] double nearest_squared(const Point& x) const {
    const double reach = sizes_.widest_m / sizes_.growth;
    double nearest = reach * reach;
    const auto beyond = [&](const Point& p) {
      const double along = p[axis_] - x[axis_];
      return along * along > nearest;
    };
    const auto& points = sizes_.points;
    const auto middle = std::lower_bound(points.begin(), points.end(), x[axis_],
                                         [this](const Point& p, double along) { return p[axis_] < along; });
    for (auto p = middle; p != points.end() && !beyond(*p); ++p) nearest = std::min(nearest, (x - *p).squaredNorm());
    for (auto p = middle; p != points.begin() && !beyond(*--p);) nearest = std::min(nearest, (x - *p).squaredNorm());
    return nearest;
  }

  Sizes sizes_;
  Eigen::Index axis_ = 0;
};

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
    explicit Is_bad(const SizeField& sizes) : sizes_(&sizes) {}
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
      const double longest = std::sqrt(side[2]);
      q.too_long = longest <= sizes_->least_m() ? 0 : longest / sizes_->at((p[0] + p[1] + p[2]) / 3);
      return operator()(q);
    }

   private:
    static constexpr double least_sine_squared = 0.125;  // Shewchuk's bound, below which refinement ends
    const SizeField* sizes_;
  };

  explicit Criteria(const SizeField& sizes) : sizes_(&sizes) {}
  [[nodiscard]] Is_bad is_bad_object() const { return Is_bad(*sizes_); }

 private:
  const SizeField* sizes_;
};

using Sides = std::vector<std::array<Triangulation::Vertex_handle, 2>>;

/// So thin that rounding decides on which side of its longest side its middle lies.
bool is_thin(const Triangulation::Triangle& triangle) {
  constexpr double thinnest = 1e-9;
  double longest_squared = 0;
  for (const int i : {0, 1, 2}) {
    longest_squared = std::max(longest_squared, CGAL::squared_distance(triangle[i], triangle[i + 1]));
  }
  return 2 * std::abs(triangle.area()) < thinnest * longest_squared;
}

/// Points on the right of the water's sides, as in blocks that it surrounds: by itself CGAL meshes holes, too. One that
/// lies in the water after all, as between a side and others in one line with it, would take all of it away.
std::vector<Kernel::Point_2> outside(const Sides& sides, const Triangulation& mesh) {
  std::vector<Kernel::Point_2> points;
  for (const auto& [from, to] : sides) {
    Triangulation::Face_handle right;
    int opposite = 0;
    if (!mesh.is_edge(from, to, right, opposite) || mesh.is_infinite(right)) continue;
    if (!is_thin(mesh.triangle(right))) points.push_back(CGAL::centroid(mesh.triangle(right)));
  }
  return points;
}

}  // namespace

std::optional<Triangulated> triangulate(const std::vector<Ring>& rings, const Sizes& sizes) {
  Triangulation mesh;
  Sides sides;
  try {
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& next = ring[(i + 1) % ring.size()];
        if (next == ring[i]) continue;
        const auto from = mesh.insert(to_cgal(ring[i]));
        sides.push_back({from, mesh.insert(to_cgal(next))});
        mesh.insert_constraint(from, sides.back()[1]);
      }
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return {};
  }
  const SizeField allowed(sizes);
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(mesh, Criteria(allowed));
  const std::vector<Kernel::Point_2> dry = outside(sides, mesh);
  mesher.set_seeds(dry.begin(), dry.end());
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
