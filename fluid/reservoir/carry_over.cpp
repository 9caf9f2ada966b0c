// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/carry_over.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

namespace bg = boost::geometry;
using RtreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<RtreePoint>;

/// A triangle of one of the meshes left.
struct Place {
  std::size_t water;
  std::size_t triangle;
};
using Entry = std::pair<Box, Place>;

/// Barycentric coordinates of x.
Eigen::Vector3d barycentric(const std::array<Point, 3>& corner, const Point& x) {
  Eigen::Matrix2d sides;
  sides << corner[1] - corner[0], corner[2] - corner[0];
  const Eigen::Vector2d l = sides.inverse() * (x - corner[0]);
  return {1 - l.sum(), l[0], l[1]};
}

/// Values of the six shape functions, corners first (water_mesh.hpp).
Eigen::Matrix<double, 6, 1> shape(const Eigen::Vector3d& l) {
  Eigen::Matrix<double, 6, 1> N;
  N << l[0] * (2 * l[0] - 1), l[1] * (2 * l[1] - 1), l[2] * (2 * l[2] - 1), 4 * l[0] * l[1], 4 * l[1] * l[2],
      4 * l[2] * l[0];
  return N;
}

class OldMeshes {
 public:
  explicit OldMeshes(const std::vector<AnsweringWater>& waters) : waters_(waters) {
    std::vector<Entry> entries;
    for (std::size_t w = 0; w < waters.size(); ++w) {
      for (std::size_t t = 0; t < waters[w].mesh().triangle.size(); ++t) entries.emplace_back(box({w, t}), Place{w, t});
    }
    triangles_ = bg::index::rtree<Entry, bg::index::quadratic<16>>(entries);
  }

  /// The triangle that x lies in, or is nearest to, and the shape functions there.
  [[nodiscard]] std::pair<Place, Eigen::Matrix<double, 6, 1>> find(const Point& x) const {
    std::vector<Entry> near;
    triangles_.query(bg::index::nearest(RtreePoint(x.x(), x.y()), 12), std::back_inserter(near));
    Place best{};
    Eigen::Vector3d at_best(0, 0, 0);
    double least = -std::numeric_limits<double>::infinity();
    for (const auto& [box, place] : near) {
      const Eigen::Vector3d l = barycentric(corners(place), x);
      if (l.minCoeff() > least) least = l.minCoeff(), best = place, at_best = l;
    }
    at_best = at_best.cwiseMax(0);
    return {best, shape(at_best / at_best.sum())};
  }

 private:
  [[nodiscard]] std::array<Point, 3> corners(const Place& place) const {
    const WaterMesh& mesh = waters_[place.water].mesh();
    const QuadraticTriangle& t = mesh.triangle[place.triangle];
    return {mesh.node[at(t[0])], mesh.node[at(t[1])], mesh.node[at(t[2])]};
  }

  [[nodiscard]] Box box(const Place& place) const {
    const auto [a, b, c] = corners(place);
    const Point low = a.cwiseMin(b).cwiseMin(c);
    const Point high = a.cwiseMax(b).cwiseMax(c);
    return {{low.x(), low.y()}, {high.x(), high.y()}};
  }

  const std::vector<AnsweringWater>& waters_;
  bg::index::rtree<Entry, bg::index::quadratic<16>> triangles_;
};

}  // namespace

PressureState carry_over(const std::vector<AnsweringWater>& from, const WaterMesh& to) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(to.node.size()));
  PressureState state{none, none, none};
  const bool at_rest = std::all_of(from.begin(), from.end(), [](const AnsweringWater& w) { return w.at_rest(); });
  if (at_rest) return state;
  const OldMeshes meshes(from);
  for (std::size_t i = 0; i < to.node.size(); ++i) {
    const auto [place, N] = meshes.find(to.node[i]);
    const AnsweringWater& water = from[place.water];
    const QuadraticTriangle& t = water.mesh().triangle[place.triangle];
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < t.size(); ++k) {
      const double share = N[static_cast<Eigen::Index>(k)];
      state.p[row] += share * water.state().p[t[k]];
      state.rate[row] += share * water.state().rate[t[k]];
      state.loaded[row] += share * water.state().loaded[t[k]];
    }
  }
  return state;
}

}  // namespace blockweir::reservoir
