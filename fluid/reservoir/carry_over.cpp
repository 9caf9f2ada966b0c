// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/carry_over.hpp"

#include <algorithm>

#include "bridge/geometry/box_index.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

/// A triangle of one of the meshes left.
struct Place {
  std::size_t water;
  std::size_t triangle;
};

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
  explicit OldMeshes(const std::vector<AnsweringWater>& waters)
      : waters_(waters), places_(all_of(waters)), triangles_(boxes()) {}

  /// The triangle that x lies in, or is nearest to, and the shape functions there.
  [[nodiscard]] std::pair<Place, Eigen::Matrix<double, 6, 1>> find(const Point& x) const {
    Place best{};
    Eigen::Vector3d at_best(0, 0, 0);
    double least = -std::numeric_limits<double>::infinity();
    for (const std::size_t near : triangles_.nearest(x, 12)) {
      const Place& place = places_[near];
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

  static std::vector<Place> all_of(const std::vector<AnsweringWater>& waters) {
    std::vector<Place> all;
    for (std::size_t w = 0; w < waters.size(); ++w) {
      for (std::size_t t = 0; t < waters[w].mesh().triangle.size(); ++t) all.push_back({w, t});
    }
    return all;
  }
  [[nodiscard]] std::vector<geometry::BoxIndex::Entry> boxes() const {
    std::vector<geometry::BoxIndex::Entry> boxes;
    for (const Place& place : places_) boxes.emplace_back(geometry::bounds_of(corners(place)), boxes.size());
    return boxes;
  }

  const std::vector<AnsweringWater>& waters_;
  std::vector<Place> places_;
  geometry::BoxIndex triangles_;
};

}  // namespace

PressureState carry_over(const std::vector<AnsweringWater>& from, const WaterMesh& to, const Point& ground_m) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(to.node.size()));
  PressureState state{none, none, none};
  const bool at_rest = std::all_of(from.begin(), from.end(), [](const AnsweringWater& w) { return w.at_rest(); });
  if (at_rest) return state;
  const OldMeshes meshes(from);
  for (std::size_t i = 0; i < to.node.size(); ++i) {
    const auto [place, N] = meshes.find(to.node[i] - ground_m);
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
