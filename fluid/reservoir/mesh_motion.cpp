// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/mesh_motion.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "bridge/geometry/box_index.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

/// Largest stretch of a triangle, and the largest compression.
constexpr double most_stretch = 2;

/// Of the square of the depth: what two outlines of one region may differ by.
constexpr double same_area = 2e-6;

std::vector<Point> known_points(const hydrostatic::WaterBody& body, const Banks& banks) {
  std::vector<Point> points = ends_of_faces(body, banks);
  points.insert(points.end(), banks.corners.begin(), banks.corners.end());
  return points;
}

std::vector<std::array<int, 2>> faces_of(const hydrostatic::WaterBody& body) {
  std::vector<std::array<int, 2>> faces;
  for (const hydrostatic::WetInterval& wet : body.wet->intervals) faces.push_back({wet.block, wet.edge});
  return faces;
}

double area_of(const std::vector<Ring>& rings) {
  return std::accumulate(rings.begin(), rings.end(), 0.0,
                         [](double sum, const Ring& ring) { return sum + geometry::signed_area(ring); });
}

/// Which of many points is the nearest.
class NearestPoint {
 public:
  explicit NearestPoint(const std::vector<Point>& points) : points_(points), index_(points) {}
  [[nodiscard]] std::size_t to(const Point& x) const { return index_.nearest(x, 1).front(); }
  /// The nearest if it is no farther than `reach_m`.
  [[nodiscard]] std::optional<std::size_t> within(double reach_m, const Point& x) const {
    if (points_.empty()) return {};
    const std::size_t nearest = to(x);
    if ((points_[nearest] - x).norm() > reach_m) return {};
    return nearest;
  }

 private:
  const std::vector<Point>& points_;
  geometry::BoxIndex index_;
};

}  // namespace

struct MeshMotion::Factors : Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> {
  using SimplicialLDLT::SimplicialLDLT;
};

MeshMotion::MeshMotion(const WaterMesh& mesh, const hydrostatic::WaterBody& body, const Banks& banks)
    : mesh_(mesh),
      faces_(faces_of(body)),
      known_(known_points(body, banks)),
      same_place_m_(20 * reservoir::same_place_m(body)) {}

MeshMotion::~MeshMotion() = default;

MeshMotion::MeshMotion(MeshMotion&& other) noexcept = default;

MeshMotion& MeshMotion::operator=(MeshMotion&& other) noexcept = default;

std::optional<WaterMesh> MeshMotion::moved(const hydrostatic::WaterBody& body, const Banks& banks,
                                           const FarEnds& ends) {
  if (faces_of(body) != faces_ || !prepare()) return {};
  const std::optional<Points> ring = points_now(body, banks, ends);
  if (!ring) return {};
  WaterMesh mesh = mesh_;
  for (const OnBoundary& b : boundary_) {
    mesh.node[at(b.node)] = (1 - b.way) * (*ring)[b.from] + b.way * (*ring)[b.to];
  }
  move_inside(mesh.node);
  if (!is_well_shaped(mesh.node)) return {};
  for (const QuadraticTriangle& t : mesh.triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.node[at(t[3 + i])] = (mesh.node[at(t[i])] + mesh.node[at(t[(i + 1) % 3])]) / 2;
    }
  }
  for (BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::face) continue;
    const auto& outline = banks.outlines[at(side.block)];
    const Point& from = outline[at(side.edge)];
    const Point span = outline[(at(side.edge) + 1) % outline.size()] - from;
    const auto along = [&](int node) {
      return std::clamp(span.dot(mesh.node[at(node)] - from) / span.squaredNorm(), 0.0, 1.0);
    };
    side.s_from = along(side.node[0]);
    side.s_to = along(side.node[2]);
  }
  mesh.ends = ends;
  mesh.depth_m = depth(body);
  return mesh;
}

/// What moving takes, found when the mesh is first moved.
bool MeshMotion::prepare() {
  if (prepared_) return can_move_;
  prepared_ = true;
  if (known_.empty()) return false;
  for (const Ring& ring : mesh_.rings) ring_.insert(ring_.end(), ring.begin(), ring.end());
  const NearestPoint known(known_);
  const NearestPoint of_ring(ring_);
  for (const Point& p : ring_) {
    anchor_.push_back(known.within(same_place_m_, p));
    nearest_known_.push_back(known.to(p));
  }
  for (const Point& p : known_) place_.push_back(of_ring.within(same_place_m_, p));
  can_move_ = trace_boundary();
  if (can_move_) factorize();
  return can_move_;
}

/// Finds between which points of the rings each node lies. False where a node is on the boundary twice.
bool MeshMotion::trace_boundary() {
  std::map<std::pair<double, double>, std::size_t> points;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    if (!points.try_emplace({ring_[i].x(), ring_[i].y()}, i).second) return false;
  }
  const auto point_at = [&](int node) -> std::optional<std::size_t> {
    const auto found = points.find({mesh_.node[at(node)].x(), mesh_.node[at(node)].y()});
    if (found == points.end()) return {};
    return found->second;
  };
  std::map<int, int> next;
  for (const BoundarySide& side : mesh_.side) {
    if (!next.try_emplace(side.node[0], side.node[2]).second) return false;
  }
  for (const auto& [start, after] : next) {
    const auto from = point_at(start);
    if (!from) continue;
    std::vector<int> between;
    int node = after;
    while (!point_at(node)) {
      between.push_back(node);
      const auto found = next.find(node);
      if (found == next.end() || between.size() > next.size()) return false;
      node = found->second;
    }
    const std::size_t to = *point_at(node);
    boundary_.push_back({start, *from, to, 0});
    const double length = (ring_[to] - ring_[*from]).norm();
    for (const int n : between) boundary_.push_back({n, *from, to, (mesh_.node[at(n)] - ring_[*from]).norm() / length});
  }
  return boundary_.size() == next.size();
}

void MeshMotion::factorize() {
  std::vector<int> of_boundary(mesh_.node.size(), -1);
  std::vector<int> of_inner(mesh_.node.size(), -1);
  for (std::size_t i = 0; i < boundary_.size(); ++i) of_boundary[at(boundary_[i].node)] = static_cast<int>(i);
  for (const QuadraticTriangle& t : mesh_.triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      int& number = of_inner[at(t[i])];
      if (number >= 0 || of_boundary[at(t[i])] >= 0) continue;
      number = static_cast<int>(inner_.size());
      inner_.push_back(t[i]);
    }
  }
  std::vector<Eigen::Triplet<double>> inside;
  std::vector<Eigen::Triplet<double>> across;
  for (const QuadraticTriangle& t : mesh_.triangle) {
    std::array<Point, 3> opposite;  // sides against the corners
    for (std::size_t i = 0; i < 3; ++i) opposite[i] = mesh_.node[at(t[(i + 2) % 3])] - mesh_.node[at(t[(i + 1) % 3])];
    const double twice_area = geometry::cross(opposite[0], opposite[1]);
    for (std::size_t i = 0; i < 3; ++i) {
      const int row = of_inner[at(t[i])];
      if (row < 0) continue;
      for (std::size_t j = 0; j < 3; ++j) {
        const double k = opposite[i].dot(opposite[j]) / (twice_area * twice_area);
        const int column = of_inner[at(t[j])];
        if (column < 0) across.emplace_back(row, of_boundary[at(t[j])], k);
        if (column >= 0 && column <= row) inside.emplace_back(row, column, k);
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(inner_.size());
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(inside.begin(), inside.end());
  to_boundary_.resize(count, static_cast<Eigen::Index>(boundary_.size()));
  to_boundary_.setFromTriplets(across.begin(), across.end());
  factors_ = std::make_unique<Factors>(matrix);
}

/// Where the points of the rings are now. Those that are no end of a face, as at far ends, are at a corner of the
/// region: the nearest to where they would be if they had moved with the nearest end of a face.
std::optional<MeshMotion::Points> MeshMotion::points_now(const hydrostatic::WaterBody& body, const Banks& banks,
                                                         const FarEnds& ends) const {
  const Points known = known_points(body, banks);
  const std::vector<Ring> region = region_of(body, banks, ends);
  if (known.size() != known_.size() || region.size() != mesh_.rings.size()) return {};
  Points corners;
  for (const Ring& ring : region) corners.insert(corners.end(), ring.begin(), ring.end());
  const auto nearest_corner = [&](const Point& p) {
    return *std::min_element(corners.begin(), corners.end(), [&](const Point& a, const Point& b) {
      return (a - p).squaredNorm() < (b - p).squaredNorm();
    });
  };
  Points points;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const std::size_t with = nearest_known_[i];
    points.push_back(anchor_[i] ? known[*anchor_[i]] : nearest_corner(ring_[i] + known[with] - known_[with]));
  }
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (place_[k] && (known[k] - points[*place_[k]]).norm() > same_place_m_) return {};  // what was one has parted
  }
  std::vector<Ring> rings;
  auto next = points.cbegin();
  for (const Ring& ring : mesh_.rings) {
    rings.emplace_back(next, next + static_cast<std::ptrdiff_t>(ring.size()));
    next += static_cast<std::ptrdiff_t>(ring.size());
  }
  const double deep = depth(body);
  if (std::abs(area_of(rings) - area_of(region)) > same_area * deep * deep) return {};
  return points;
}

void MeshMotion::move_inside(std::vector<Point>& node) const {
  if (inner_.empty()) return;
  Eigen::MatrixX2d at_boundary(static_cast<Eigen::Index>(boundary_.size()), 2);
  for (std::size_t i = 0; i < boundary_.size(); ++i) {
    at_boundary.row(static_cast<Eigen::Index>(i)) = node[at(boundary_[i].node)] - mesh_.node[at(boundary_[i].node)];
  }
  const Eigen::MatrixX2d u = factors_->solve(-(to_boundary_ * at_boundary));
  for (std::size_t i = 0; i < inner_.size(); ++i)
    node[at(inner_[i])] += u.row(static_cast<Eigen::Index>(i)).transpose();
}

/// No triangle is stretched or compressed by more than most_stretch in any direction: both singular values of the
/// gradient F of its motion are within these bounds.
bool MeshMotion::is_well_shaped(const std::vector<Point>& node) const {
  const auto sides = [](const std::vector<Point>& nodes, const QuadraticTriangle& t) {
    Eigen::Matrix2d both;
    both << nodes[at(t[1])] - nodes[at(t[0])], nodes[at(t[2])] - nodes[at(t[0])];
    return both;
  };
  constexpr double most = most_stretch * most_stretch;
  return std::all_of(mesh_.triangle.begin(), mesh_.triangle.end(), [&](const QuadraticTriangle& t) {
    const Eigen::Matrix2d F = sides(node, t) * sides(mesh_.node, t).inverse();
    const double area = F.determinant();  // s1 s2
    const double sum = F.squaredNorm();   // s1^2 + s2^2
    // Both squares are within 1/most to most: the polynomial (x - s1^2)(x - s2^2) is not negative beyond their mean.
    const auto beyond = [&](double x) { return x * x - sum * x + area * area >= 0; };
    return area > 0 && sum < 2 * most && sum > 2 / most && beyond(most) && beyond(1 / most);
  });
}

}  // namespace blockweir::reservoir
