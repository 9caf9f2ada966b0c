// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step solid_suitesparse
// What solves a step's linear system soonest: dense LU, sparse Cholesky (from nothing, on a known pattern with the four
// threads that CHOLMOD asks for and with one, with kept factors) or conjugate gradients preconditioned by the blocks'
// own 3x3 or 6x6 matrices (from nothing, and from a solution whose right-hand side was 1 % off), by the number of
// blocks. The matrix is that of a brick wall at rest, every contact with the penalty that the solid gave it. Arguments:
// numbers of blocks (20 100 1000 10000 100000; of deformable ones up to 1000, for larger walls of them take long to
// settle).
#include <fmt/format.h>

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "solid/solve/sparse/one_thread.hpp"
#include "solid/step/newmark.hpp"
#include "solid/step/solid.hpp"
#include "tests/large_scenes.hpp"

namespace {

using namespace blockweir;
using Matrix = Eigen::SparseMatrix<double>;

constexpr double accurate = 1e-8;  // of the right-hand side
constexpr std::ptrdiff_t largest_dense = 3000;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Factors of the blocks on the diagonal, as Eigen asks of a preconditioner.
class BlockJacobi {
 public:
  static inline int unknowns = 3;  // of a block; Eigen makes the preconditioner itself

  BlockJacobi& analyzePattern(const Matrix&) { return *this; }
  BlockJacobi& factorize(const Matrix& k) {
    inverse_.clear();
    for (Eigen::Index first = 0; first < k.rows(); first += unknowns) {
      const Small own = k.block(first, first, unknowns, unknowns);
      inverse_.emplace_back(own.inverse());
    }
    return *this;
  }
  BlockJacobi& compute(const Matrix& k) { return factorize(k); }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& f) const {
    Eigen::VectorXd d(f.size());
    Eigen::Index first = 0;
    for (const Small& inverse : inverse_) {
      d.segment(first, unknowns).noalias() = inverse * f.segment(first, unknowns);
      first += unknowns;
    }
    return d;
  }
  [[nodiscard]] static Eigen::ComputationInfo info() { return Eigen::Success; }

 private:
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  std::vector<Small> inverse_;
};

/// First-order shape matrix (1)-(3) of a block at a vertex.
Eigen::Matrix<double, 2, 6> shape(const Eigen::Vector2d& p) {
  Eigen::Matrix<double, 2, 6> t;
  t << 1, 0, -p.y(), p.x(), 0, p.y() / 2, 0, 1, p.x(), 0, p.y(), p.x() / 2;
  return t;
}

/// Blocks on the diagonal, and what closed contacts that stick add; fixed blocks have no part.
Matrix matrix_of(const solid::Solid& solid, double dt, int unknowns) {
  const auto& blocks = solid.blocks();
  std::vector<Eigen::Index> first(blocks.size(), -1);
  Eigen::Index size = 0;
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::size_t row, std::size_t column, const Eigen::Matrix<double, 6, 6>& k) {
    if (first[row] < 0 || first[column] < 0) return;
    for (int i = 0; i < unknowns; ++i) {
      for (int j = 0; j < unknowns; ++j) {
        entries.emplace_back(static_cast<int>(first[row] + i), static_cast<int>(first[column] + j), k(i, j));
      }
    }
  };
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].fixed) continue;
    first[b] = size;
    size += unknowns;
    solid::Matrix6 own = solid::Newmark{}.mass_factor(dt) * blocks[b].inertia.matrix();
    own.bottomRightCorner<3, 3>() += blocks[b].stiffness;
    add(b, b, own);
  }
  for (const solid::ContactPoint& c : solid.contacts()) {
    if (c.state == solid::ContactState::open) continue;
    const auto i = static_cast<std::size_t>(c.vertex_block);
    const auto j = static_cast<std::size_t>(c.edge_block);
    const Eigen::Vector2d place = blocks[i].centroid + blocks[i].vertices[static_cast<std::size_t>(c.vertex)];
    const auto shape_i = shape(place - blocks[i].centroid);
    const auto shape_j = shape(place - blocks[j].centroid);
    add(i, i, c.penalty * shape_i.transpose() * shape_i);
    add(j, j, c.penalty * shape_j.transpose() * shape_j);
    add(i, j, -c.penalty * shape_i.transpose() * shape_j);
    add(j, i, -c.penalty * shape_j.transpose() * shape_i);
  }
  Matrix k(size, size);
  k.setFromTriplets(entries.begin(), entries.end());
  return k;
}

std::string milliseconds(double s) {
  return s < 0 ? "-" : fmt::format("{:.3g}", 1e3 * s);
}

void row(int bricks, bool rigid) {
  scene::Scene scene = brick_wall(bricks);
  scene.analysis.rigid = rigid ? scene::Rigid::all : scene::Rigid::none;
  // That its contacts hold is enough here: friction at its bounds is large_bench's matter.
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 80;
  solid::Solid solid(scene);
  solid.settle({});
  const int unknowns = rigid ? 3 : 6;
  BlockJacobi::unknowns = unknowns;
  const Matrix k = matrix_of(solid, scene.analysis.step_s, unknowns);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(k.rows());
  for (Eigen::Index i = 1; i < k.rows(); i += unknowns) weight[i] = -1570;  // of a brick a metre deep [N/m]

  double dense_s = -1;
  if (k.rows() <= largest_dense) {
    const Eigen::MatrixXd full = k;
    dense_s = seconds([&] { (void)Eigen::PartialPivLU<Eigen::MatrixXd>(full).solve(weight).eval(); });
  }
  Eigen::CholmodDecomposition<Matrix> cholesky;
  Eigen::VectorXd answer;
  const double analyse_s = seconds([&] { cholesky.analyzePattern(k); });
  const double four_threads_s = seconds([&] { cholesky.factorize(k); });
  const double factorize_s = seconds([&] {
    const solid::OneThread one;
    cholesky.factorize(k);
  });
  const double kept_s = seconds([&] { answer = cholesky.solve(weight); });

  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, BlockJacobi> gradients;
  gradients.setTolerance(accurate);
  gradients.setMaxIterations(20'000);
  Eigen::VectorXd found;
  const double cold_s = seconds([&] { found = gradients.compute(k).solve(weight); });
  const auto cold = gradients.iterations();
  const double off = (found - answer).norm() / answer.norm();
  Eigen::VectorXd other = weight;
  for (Eigen::Index i = 0; i < other.size(); ++i) other[i] *= 1 + 0.01 * std::sin(static_cast<double>(i));
  const Eigen::VectorXd guess = cholesky.solve(other);
  const double warm_s = seconds([&] { found = gradients.compute(k).solveWithGuess(weight, guess); });
  fmt::print("{:<12} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>6} {:>9} {:>6} {:>9.1e}\n",
             rigid ? "rigid" : "deformable", k.rows() / unknowns, milliseconds(dense_s),
             milliseconds(analyse_s + factorize_s + kept_s), milliseconds(four_threads_s + kept_s),
             milliseconds(factorize_s + kept_s), milliseconds(kept_s), milliseconds(cold_s), cold, milliseconds(warm_s),
             gradients.iterations(), off);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  const bool usual = sizes.empty();
  if (usual) sizes = {20, 100, 1'000, 10'000, 100'000};
  fmt::print("{:<12} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>6} {:>9} {:>6} {:>9}\n", "milliseconds", "blocks",
             "dense", "Cholesky", "4 threads", "1 thread", "factors", "gradients", "its", "warm", "its", "off");
  for (const bool rigid : {true, false}) {
    for (const int bricks : sizes) {
      if (usual && !rigid && bricks > 1'000) continue;
      try {
        row(bricks, rigid);
      } catch (const std::exception& error) {
        fmt::print("{:<12} {:>8} {}\n", rigid ? "rigid" : "deformable", bricks, error.what());
      }
    }
  }
}
