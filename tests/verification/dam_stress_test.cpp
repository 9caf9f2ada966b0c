// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_expect
// A gravity dam's displacements and stresses by the solid's meshes against finite elements of second order that share
// no code with it: triangles of six nodes on a regular grid, solved by Eigen.
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <cmath>

#include "solid/expect/point_figures.hpp"

namespace blockweir::solid::dam_stress_test {
namespace {

constexpr double height = 30;
constexpr double base = 24;
constexpr double crest = 3;
constexpr double modulus = 30e9;
constexpr double poisson = 0.2;
constexpr double unit_weight = 2400 * 9.81;
constexpr double unit_weight_of_water = 9810;

/// Plane strain, the base held, own weight and a reservoir up to the crest.
class ReferenceDam {
 public:
  explicit ReferenceDam(int cells)
      : n_(2 * cells + 1), K_(2 * n_ * n_, 2 * n_ * n_), f_(Eigen::VectorXd::Zero(2 * n_ * n_)) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j + 2 < n_; j += 2) {
      for (int i = 0; i + 2 < n_; i += 2) {
        add({id(i, j), id(i + 2, j), id(i + 2, j + 2), id(i + 1, j), id(i + 2, j + 1), id(i + 1, j + 1)}, entries);
        add({id(i, j), id(i + 2, j + 2), id(i, j + 2), id(i + 1, j + 1), id(i + 1, j + 2), id(i, j + 1)}, entries);
      }
      push_face(j);
    }
    std::vector<Eigen::Triplet<double>> free;
    for (const auto& e : entries) {
      if (held(e.row()) || held(e.col())) continue;
      free.push_back(e);
    }
    for (int k = 0; k < 2 * n_; ++k) {
      free.emplace_back(k, k, 1.0);
      f_[k] = 0;
    }
    K_.setFromTriplets(free.begin(), free.end());
    u_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K_).solve(f_);
  }

  /// At grid fractions (across, up).
  [[nodiscard]] Point displacement(double across, double up) const {
    const int k = id(static_cast<int>(std::lround(across * (n_ - 1))), static_cast<int>(std::lround(up * (n_ - 1))));
    return u_.segment<2>(2 * k);
  }
  /// Vertical stress there, the mean of the triangles that meet in that corner node.
  [[nodiscard]] double stress_yy(double across, double up) const {
    const int i = static_cast<int>(std::lround(across * (n_ - 1)));
    const int j = static_cast<int>(std::lround(up * (n_ - 1)));
    double sum = 0;
    int count = 0;
    for (const Triangle& t : triangles_) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (t[c] != id(i, j)) continue;
        sum += (hooke() * strain(t, c == 1 ? 1 : 0, c == 2 ? 1 : 0))[1];
        ++count;
      }
    }
    return sum / count;
  }
  static Point place(double across, double up) { return {across * (base + (crest - base) * up), up * height}; }

 private:
  using Triangle = std::array<int, 6>;  // corners, then the middles of 01, 12, 20

  [[nodiscard]] int id(int i, int j) const { return j * n_ + i; }
  [[nodiscard]] bool held(int unknown) const { return unknown < 2 * n_; }
  [[nodiscard]] Point node(int k) const { return place(double(k % n_) / (n_ - 1), double(k / n_) / (n_ - 1)); }
  static Eigen::Matrix3d hooke() {
    Eigen::Matrix3d D;
    D << 1 - poisson, poisson, 0, poisson, 1 - poisson, 0, 0, 0, 0.5 - poisson;
    return modulus / ((1 + poisson) * (1 - 2 * poisson)) * D;
  }
  /// Derivatives of the six shape functions by the local coordinates (r, s).
  static Eigen::Matrix<double, 2, 6> slopes(double r, double s) {
    const double q = 1 - r - s;
    Eigen::Matrix<double, 2, 6> d;
    d << 1 - 4 * q, 4 * r - 1, 0, 4 * (q - r), 4 * s, -4 * s,  //
        1 - 4 * q, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (q - s);
    return d;
  }
  static Eigen::Matrix<double, 6, 1> values(double r, double s) {
    const double q = 1 - r - s;
    return (Eigen::Matrix<double, 6, 1>() << q * (2 * q - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * q * r, 4 * r * s,
            4 * s * q)
        .finished();
  }
  /// Strain rows per unknown, and the area per local area.
  std::pair<Eigen::Matrix<double, 3, 12>, double> strain_matrix(const Triangle& t, double r, double s) const {
    const Eigen::Matrix<double, 2, 6> local = slopes(r, s);
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for (int k = 0; k < 6; ++k) J += local.col(k) * node(t[static_cast<std::size_t>(k)]).transpose();
    const Eigen::Matrix<double, 2, 6> g = J.inverse() * local;
    Eigen::Matrix<double, 3, 12> B = Eigen::Matrix<double, 3, 12>::Zero();
    for (int k = 0; k < 6; ++k) {
      B(0, 2 * k) = B(2, 2 * k + 1) = g(0, k);
      B(1, 2 * k + 1) = B(2, 2 * k) = g(1, k);
    }
    return {B, J.determinant()};
  }
  [[nodiscard]] Eigen::Vector3d strain(const Triangle& t, double r, double s) const {
    Eigen::Matrix<double, 12, 1> u;
    for (int k = 0; k < 6; ++k) u.segment<2>(2 * k) = u_.segment<2>(2 * t[static_cast<std::size_t>(k)]);
    return strain_matrix(t, r, s).first * u;
  }
  void add(const Triangle& t, std::vector<Eigen::Triplet<double>>& entries) {
    triangles_.push_back(t);
    for (const auto& [r, s] : {std::pair(1.0 / 6, 1.0 / 6), std::pair(2.0 / 3, 1.0 / 6), std::pair(1.0 / 6, 2.0 / 3)}) {
      const auto [B, area] = strain_matrix(t, r, s);
      const Eigen::Matrix<double, 12, 12> k = area / 6 * B.transpose() * hooke() * B;
      for (int a = 0; a < 12; ++a) {
        for (int b = 0; b < 12; ++b) {
          const auto unknown = [&](int c) { return 2 * t[static_cast<std::size_t>(c / 2)] + c % 2; };
          entries.emplace_back(unknown(a), unknown(b), k(a, b));
        }
      }
      const Eigen::Matrix<double, 6, 1> N = values(r, s);
      for (int c = 0; c < 6; ++c) f_[2 * t[static_cast<std::size_t>(c)] + 1] -= area / 6 * N[c] * unit_weight;
    }
  }
  /// Consistent forces of the water on three nodes of the upstream face (Simpson is exact for them up to the third
  /// degree).
  void push_face(int j) {
    const double length = node(id(0, j + 2)).y() - node(id(0, j)).y();
    for (int k = 0; k < 3; ++k) {
      const double depth = height - node(id(0, j + k)).y();
      f_[2 * id(0, j + k)] += length / 6 * (k == 1 ? 4 : 1) * unit_weight_of_water * depth;
    }
  }

  int n_;  ///< nodes a side
  std::vector<Triangle> triangles_;
  Eigen::SparseMatrix<double> K_;
  Eigen::VectorXd f_;
  Eigen::VectorXd u_;
};

scene::Scene dam(double mesh_size_m) {
  scene::Scene scene;
  scene.materials.push_back({"concrete", modulus, poisson, 2400});
  scene.default_joint.cohesion_pa = scene.default_joint.tension_strength_pa = 1e9;
  scene.blocks.push_back({.name = "rock", .vertices = {{-20, -10}, {44, -10}, {44, 0}, {-20, 0}}, .fixed = true});
  scene.blocks.push_back({.name = "dam", .vertices = {{0, 0}, {base, 0}, {crest, height}, {0, height}}});
  scene.blocks[1].mesh_size_m = mesh_size_m;
  scene.face_pressures.push_back({.block = 1,
                                  .from_m = {0, height},
                                  .to_m = {0, 0},
                                  .pressure_from_pa = scene::TimeTable::constant(0),
                                  .pressure_to_pa = scene::TimeTable::constant(unit_weight_of_water * height)});
  return scene;
}

/// Slope of log error over log size, by least squares.
double order(const std::vector<double>& sizes, const std::vector<double>& errors) {
  Eigen::MatrixX2d A(static_cast<Eigen::Index>(sizes.size()), 2);
  Eigen::VectorXd b(A.rows());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    A.row(static_cast<Eigen::Index>(i)) << 1, std::log(sizes[i]);
    b[static_cast<Eigen::Index>(i)] = std::log(errors[i]);
  }
  return Eigen::Vector2d(A.colPivHouseholderQr().solve(b))[1];
}

TEST(DamStress, ConvergesToFiniteElementsOfSecondOrder) {
  const ReferenceDam reference(40);
  // Stresses away from heel and toe, where they are singular; displacements all over the dam.
  std::vector<std::pair<double, double>> places;
  std::vector<std::pair<double, double>> inner;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 1; j <= 10; ++j) {
      places.emplace_back(i / 10.0, j / 10.0);
      if (j >= 3 && j <= 8) inner.push_back(places.back());
    }
  }
  const double count = static_cast<double>(places.size());
  double moved = 0;
  double stressed = 0;
  for (const auto& [across, up] : places) moved += reference.displacement(across, up).squaredNorm() / count;
  for (const auto& [across, up] : inner) stressed = std::max(stressed, std::abs(reference.stress_yy(across, up)));

  std::printf("at mid-height the reference has %.5g Pa upstream, %.5g Pa downstream\n", reference.stress_yy(0, 0.5),
              reference.stress_yy(1, 0.5));

  const std::vector<double> sizes = {4, 2, 1};
  std::vector<double> displacement_errors;
  std::vector<double> stress_errors;
  for (const double size : sizes) {
    const auto scene = dam(size);
    Solid solid(scene);
    solid.settle({});
    const auto along = [&](const char* axis, const Point& p) {
      return expect::point_quantities().at(axis)(solid, 1, p);
    };
    double squares = 0;
    for (const auto& [across, up] : places) {
      const Point p = ReferenceDam::place(across, up);
      const Point got(along("point_displacement_x_m", p), along("point_displacement_y_m", p));
      squares += (got - reference.displacement(across, up)).squaredNorm() / count;
    }
    displacement_errors.push_back(std::sqrt(squares / moved));
    squares = 0;
    const StressField field(solid, 1);
    for (const auto& [across, up] : inner) {
      const double error = field.stress_at(ReferenceDam::place(across, up))[1] - reference.stress_yy(across, up);
      squares += error * error / static_cast<double>(inner.size());
    }
    stress_errors.push_back(std::sqrt(squares) / stressed);
    std::printf("mesh %4.2f m, %5zu triangles: displacements off by %.2e, stresses by %.2e\n", size,
                solid.parts().triangles[1].size(), displacement_errors.back(), stress_errors.back());
  }
  std::printf("order %.2f in displacement, %.2f in stress\n", order(sizes, displacement_errors),
              order(sizes, stress_errors));
  EXPECT_LT(displacement_errors.back(), 5e-3);
  EXPECT_LT(stress_errors.back(), 1e-2);
  EXPECT_GT(order(sizes, displacement_errors), 1.2);  // below 2: stresses are singular at heel and toe
  EXPECT_GT(order(sizes, stress_errors), 1.2);
}

}  // namespace
}  // namespace blockweir::solid::dam_stress_test
