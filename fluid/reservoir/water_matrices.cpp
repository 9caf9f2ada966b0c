// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/water_matrices.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Kind = BoundarySide::Kind;

double twice_area(const std::array<Point, 3>& corner) {
  const Point a = corner[1] - corner[0];
  const Point b = corner[2] - corner[0];
  return a.x() * b.y() - a.y() * b.x();
}

/// From that of the linear triangle, k_ij = A grad l_i . grad l_j with the barycentric coordinates l, as l_i l_j and
/// the like have closed integrals.
Matrix6 stiffness_of(const std::array<Point, 3>& corner) {
  std::array<Point, 3> opposite;  // sides against the corners
  for (std::size_t i = 0; i < 3; ++i) opposite[i] = corner[(i + 2) % 3] - corner[(i + 1) % 3];
  const double four_areas = 2 * twice_area(corner);
  Matrix6 K = Matrix6::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto at = [](Eigen::Index corner_number) { return static_cast<std::size_t>(corner_number); };
    const Eigen::Index j = (i + 1) % 3;
    const Eigen::Index l = (i + 2) % 3;
    const double k_ii = opposite[at(i)].squaredNorm() / four_areas;
    const double k_jj = opposite[at(j)].squaredNorm() / four_areas;
    const double k_ij = opposite[at(i)].dot(opposite[at(j)]) / four_areas;
    K(i, i) = k_ii;
    K(i, j) = K(j, i) = -k_ij / 3;
    const Eigen::Index middle = 3 + i;  // of i and j
    K(i, middle) = K(middle, i) = K(j, middle) = K(middle, j) = 4 * k_ij / 3;
    K(middle, middle) = 8 * (k_ii + k_jj + k_ij) / 3;
    K(3 + j, 3 + l) = K(3 + l, 3 + j) = 8 * k_ij / 3;  // middles of j and l, of l and i: they share l
  }
  return K;
}

/// Of a triangle of unit area.
Matrix6 triangle_mass() {
  return (Matrix6() << 6, -1, -1, 0, -4, 0,  //
          -1, 6, -1, 0, 0, -4,               //
          -1, -1, 6, -4, 0, 0,               //
          0, 0, -4, 32, 16, 16,              //
          -4, 0, 0, 16, 32, 16,              //
          0, -4, 0, 16, 16, 32)
             .finished() /
         180;
}

/// sigma over the wave's speed at x: waves that run into the stretch and back keep a thousandth of their height.
double absorption_per_m(const FarEnd& end, double x) {
  if (!end.absorbs_from_m) return 0;
  const double length = end.x_m - *end.absorbs_from_m;  // below zero on the left
  const double way = (x - *end.absorbs_from_m) / length;
  return way > 0 ? 1.5 * std::log(1e3) / std::abs(length) * way * way : 0;
}

double absorption_per_m(const FarEnds& ends, double x) {
  return absorption_per_m(ends.left, x) + absorption_per_m(ends.right, x);
}

/// Adds up the lower half of a matrix.
class Sum {
 public:
  Sum(const Unknowns& unknowns) : unknowns_(unknowns) {}

  template <std::size_t N, class Element>
  void add(const std::array<int, N>& node, const Element& element, double factor) {
    if (factor == 0) return;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        const int row = unknowns_.of_node[at(node[i])];
        const int column = unknowns_.of_node[at(node[j])];
        if (row < 0 || column < 0 || row < column) continue;
        entries_.emplace_back(row, column,
                              factor * element(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }

  [[nodiscard]] Eigen::SparseMatrix<double> matrix() const {
    Eigen::SparseMatrix<double> sum(unknowns_.count, unknowns_.count);
    sum.setFromTriplets(entries_.begin(), entries_.end());
    return sum;
  }

 private:
  const Unknowns& unknowns_;
  std::vector<Eigen::Triplet<double>> entries_;
};

struct Sums {
  Sum K;
  Sum C;
  Sum M;
};

void add_triangles(const WaterMesh& mesh, const WaterPhysics& physics, Sums& sums) {
  const double c = physics.sound_speed_m_per_s;
  const Matrix6 mass = triangle_mass();
  for (const QuadraticTriangle& t : mesh.triangle) {
    const std::array<Point, 3> corner{mesh.node[at(t[0])], mesh.node[at(t[1])], mesh.node[at(t[2])]};
    const double area = twice_area(corner) / 2;
    const double sigma_over_c = absorption_per_m(mesh.ends, (corner[0] + corner[1] + corner[2]).x() / 3);
    sums.K.add(t, stiffness_of(corner), 1);
    sums.M.add(t, mass, area / c / c);
    sums.C.add(t, mass, 2 * sigma_over_c * area / c);
  }
}

void add_sides(const WaterMesh& mesh, const WaterPhysics& physics, const std::vector<bool>& ground, Sums& sums) {
  const double c = physics.sound_speed_m_per_s;
  const double g = physics.gravity_m_per_s2;
  const double alpha = physics.bottom_reflection;
  const double wave_speed = std::isfinite(g) ? std::sqrt(g * mesh.depth_m) : 0;
  const Eigen::Matrix3d mass = side_mass();
  for (const BoundarySide& side : mesh.side) {
    const double length = (mesh.node[at(side.node[2])] - mesh.node[at(side.node[0])]).norm();
    const bool on_ground = side.kind == Kind::bed || (side.kind == Kind::face && ground[at(side.block)]);
    if (side.kind == Kind::surface) {
      const double sigma = wave_speed * absorption_per_m(mesh.ends, mesh.node[at(side.node[1])].x());
      sums.M.add(side.node, mass, length / g);
      sums.C.add(side.node, mass, 2 * sigma * length / g);
    } else if (on_ground) {
      sums.C.add(side.node, mass, (1 - alpha) / (1 + alpha) / c * length);
    } else if (side.kind == Kind::far_end) {
      sums.C.add(side.node, mass, length / c);
    }
  }
}

}  // namespace

Eigen::Matrix3d side_mass() {
  return (Eigen::Matrix3d() << 4, 2, -1, 2, 16, 2, -1, 2, 4).finished() / 30;
}

Unknowns unknowns_of(const WaterMesh& mesh, bool surface_moves) {
  Unknowns unknowns{std::vector<int>(mesh.node.size(), 0), 0};
  for (const BoundarySide& side : mesh.side) {
    if (surface_moves || side.kind != Kind::surface) continue;
    for (const int node : side.node) unknowns.of_node[at(node)] = -1;
  }
  for (int& unknown : unknowns.of_node) {
    if (unknown == 0) unknown = static_cast<int>(unknowns.count++);
  }
  return unknowns;
}

WaterMatrices matrices_of(const WaterMesh& mesh, const Unknowns& unknowns, const WaterPhysics& physics,
                          const std::vector<bool>& ground) {
  Sums sums{Sum(unknowns), Sum(unknowns), Sum(unknowns)};
  add_triangles(mesh, physics, sums);
  add_sides(mesh, physics, ground, sums);
  return {sums.K.matrix(), sums.C.matrix(), sums.M.matrix()};
}

StiffnessMatrix::StiffnessMatrix(const WaterMesh& mesh, const Unknowns& unknowns) {
  Sum sum(unknowns);
  for (const QuadraticTriangle& t : mesh.triangle) sum.add(t, Matrix6::Ones(), 1);
  K_ = sum.matrix();
  for (const QuadraticTriangle& t : mesh.triangle) {
    auto place = place_.emplace_back().begin();
    for (std::size_t i = 0; i < t.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const auto [column, row] = std::minmax(unknowns.of_node[at(t[i])], unknowns.of_node[at(t[j])]);
        *place++ = column < 0 ? -1 : static_cast<int>(&K_.coeffRef(row, column) - K_.valuePtr());
      }
    }
  }
}

const Eigen::SparseMatrix<double>& StiffnessMatrix::of(const WaterMesh& mesh) {
  K_.coeffs().setZero();
  for (std::size_t n = 0; n < mesh.triangle.size(); ++n) {
    const QuadraticTriangle& t = mesh.triangle[n];
    const Matrix6 K = stiffness_of({mesh.node[at(t[0])], mesh.node[at(t[1])], mesh.node[at(t[2])]});
    auto place = place_[n].begin();
    for (Eigen::Index i = 0; i < 6; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j, ++place) {
        if (*place >= 0) K_.valuePtr()[*place] += K(i, j);
      }
    }
  }
  return K_;
}

}  // namespace blockweir::reservoir
