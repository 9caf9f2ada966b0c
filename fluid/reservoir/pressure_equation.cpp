// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/pressure_equation.hpp"

#include <stdexcept>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

/// Of one triangle: exact with the three middles as points of integration, as gradients are linear.
Eigen::Matrix<double, 6, 6> stiffness_of(const std::array<Point, 3>& corner) {
  std::array<Point, 3> gradient;  // of the barycentric coordinates
  const Point a = corner[1] - corner[0];
  const Point b = corner[2] - corner[0];
  const double twice_area = a.x() * b.y() - a.y() * b.x();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point opposite = corner[(i + 2) % 3] - corner[(i + 1) % 3];
    gradient[i] = Point(-opposite.y(), opposite.x()) / twice_area;
  }
  Eigen::Matrix<double, 6, 6> K = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t q = 0; q < 3; ++q) {
    std::array<double, 3> l{};  // barycentric coordinates of the middle of side q
    l[q] = l[(q + 1) % 3] = 0.5;
    Eigen::Matrix<double, 2, 6> B;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      B.col(static_cast<Eigen::Index>(i)) = (4 * l[i] - 1) * gradient[i];
      B.col(static_cast<Eigen::Index>(3 + i)) = 4 * (l[i] * gradient[j] + l[j] * gradient[i]);
    }
    K += twice_area / 6 * B.transpose() * B;
  }
  return K;
}

}  // namespace

Eigen::Matrix3d side_mass() {
  return (Eigen::Matrix3d() << 4, 2, -1, 2, 16, 2, -1, 2, 4).finished() / 30;
}

PressureEquation::PressureEquation(const WaterMesh& mesh, double density_kg_per_m3)
    : mesh_(mesh), density_(density_kg_per_m3), unknown_(mesh.node.size(), 0) {
  for (const BoundarySide& side : mesh.side) {
    if (side.kind != BoundarySide::Kind::surface) continue;
    for (const int node : side.node) unknown_[at(node)] = -1;
  }
  for (int& unknown : unknown_) {
    if (unknown == 0) unknown = static_cast<int>(free_++);
  }
  factors_.compute(stiffness());
  if (factors_.info() != Eigen::Success) {
    throw std::runtime_error("the reservoir's equation is singular: has its water a surface?");
  }
}

Eigen::SparseMatrix<double> PressureEquation::stiffness() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(21 * mesh_.triangle.size());
  for (const QuadraticTriangle& t : mesh_.triangle) {
    const auto K = stiffness_of({mesh_.node[at(t[0])], mesh_.node[at(t[1])], mesh_.node[at(t[2])]});
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        const int row = unknown_[at(t[i])];
        const int column = unknown_[at(t[j])];
        if (row < 0 || column < 0 || row < column) continue;  // the lower half
        entries.emplace_back(row, column, K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }
  Eigen::SparseMatrix<double> K(free_, free_);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

Eigen::VectorXd PressureEquation::flux(const Moves& moves, const Acceleration& acceleration) const {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh_.node.size()));
  const Eigen::Matrix3d mass = side_mass();
  for (const BoundarySide& side : mesh_.side) {
    if (!moves(side)) continue;
    const Point span = mesh_.node[at(side.node[2])] - mesh_.node[at(side.node[0])];
    const Point normal(span.y(), -span.x());  // out of the water, of the side's length
    Eigen::Vector3d along;
    for (Eigen::Index i = 0; i < 3; ++i) {
      along[i] = acceleration(mesh_.node[at(side.node[static_cast<std::size_t>(i)])]).dot(normal);
    }
    const Eigen::Vector3d share = mass * along;
    for (Eigen::Index i = 0; i < 3; ++i) g[side.node[static_cast<std::size_t>(i)]] += share[i];
  }
  return g;
}

Eigen::VectorXd PressureEquation::pressure(const Eigen::VectorXd& flux) const {
  Eigen::VectorXd right(free_);
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    if (unknown_[i] >= 0) right[unknown_[i]] = -density_ * flux[static_cast<Eigen::Index>(i)];
  }
  const Eigen::VectorXd found = factors_.solve(right);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh_.node.size()));
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    if (unknown_[i] >= 0) p[static_cast<Eigen::Index>(i)] = found[unknown_[i]];
  }
  return p;
}

}  // namespace blockweir::reservoir
