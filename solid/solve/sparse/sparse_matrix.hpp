// SPDX-License-Identifier: GPL-3.0-or-later
// A sparse matrix with a fixed pattern, so that the symbolic factorization is done once: Cholesky (CHOLMOD) while it is
// symmetric, LU (KLU, UMFPACK where it is large) while contacts slip. Factors are kept, too, and used for similar
// matrices.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/KLUSupport>
#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

#include "bridge/results/stopwatch.hpp"
#include "solid/solve/linear_system.hpp"
#include "solid/solve/sparse/diagonal_lu.hpp"
#include "solid/solve/sparse/one_thread.hpp"
#include "solid/solve/sparse/woodbury_correction.hpp"

namespace blockweir::solid {

class SparseMatrix {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Large LU without its own refinement: solve() refines where needed. A matrix that is not positive definite is an
  /// expected result, so CHOLMOD prints nothing.
  SparseMatrix() {
    large_lu_.solver.umfpackControl()[UMFPACK_IRSTEP] = 0;
    cholesky_.solver.cholmod().print = 0;
  }

  /// Zero entries at these positions.
  void set_pattern(int size, const std::vector<Eigen::Triplet<double>>& entries) {
    k.resize(size, size);
    k.setFromTriplets(entries.begin(), entries.end());
    k.makeCompressed();
  }
  void set_zero() {
    std::fill_n(k.valuePtr(), k.nonZeros(), 0.0);
    beside_ = {};
  }
  /// What is solved with is k + U S U^T.
  void set_beside(LowRank beside) { beside_ = std::move(beside); }

  void keep_pivots_on_diagonal() { on_diagonal_ = true; }

  /// Makes the next solve factorize again.
  void forget_factors() {
    cholesky_.matrix = {};
    lu_.matrix = {};
    diagonal_lu_.matrix = {};
    large_lu_.matrix = {};
  }

  /// From a matrix with this pattern: the factors become those that gave `kept`, to the bit.
  [[nodiscard]] KeptFactors kept() const { return {cholesky_.matrix, large() ? large_lu_.matrix : lu_.matrix}; }
  void restore(const KeptFactors& kept) {
    restore(cholesky_, kept.cholesky);
    large() ? restore(large_lu_, kept.lu) : restore(lu_, kept.lu);
  }

  /// False if the matrix is singular to working accuracy.
  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    by_cholesky_ = symmetric;
    if (symmetric) return solve_with(cholesky_, f, d);
    if (on_diagonal_) return solve_with(diagonal_lu_, f, d);
    return large() ? solve_with(large_lu_, f, d) : solve_with(lu_, f, d);
  }
  /// With the factors of the last solve.
  [[nodiscard]] Eigen::VectorXd solve_again(const Eigen::VectorXd& f) {
    Eigen::VectorXd d;
    by_cholesky_   ? refine(cholesky_, f, d)
    : on_diagonal_ ? refine(diagonal_lu_, f, d)
    : large()      ? refine(large_lu_, f, d)
                   : refine(lu_, f, d);
    return d;
  }
  /// Whether the last solve reused factors.
  [[nodiscard]] bool reused() const { return reused_; }
  [[nodiscard]] SolutionTimes times() const { return times_; }

  [[nodiscard]] Eigen::MatrixXd dense() const {
    Eigen::MatrixXd all = k;
    if (!beside_.none()) all += beside_.U * beside_.S * beside_.U.transpose();
    return all;
  }

  Matrix k;

 private:
  /// KLU has no dense fronts: of walls of 70, 420 and 1,025 bricks (210, 1,260 and 3,075 unknowns) it takes 0.07, 2.1
  /// and 10.5 ms, UMFPACK 0.22, 2.3 and 7.5.
  [[nodiscard]] bool large() const { return k.cols() > 1200; }

  template <class Solver>
  struct Factors {
    Solver solver;
    bool analysed = false;
    KeptFactors::Matrix matrix;  ///< that they were made of
    WoodburyCorrection beside;
  };

  template <class Solver>
  bool solve_with(Factors<Solver>& factors, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    const bool same =
        factors.matrix.made() && std::equal(factors.matrix.values.begin(), factors.matrix.values.end(), k.valuePtr());
    reused_ = same || (factors.matrix.made() && serves(factors, f, d));
    if (reused_) {
      if (same) d = by_factors(factors, f);
      return d.allFinite();
    }
    factorize(factors);
    if (factors.solver.info() != Eigen::Success) {
      factors.matrix.values.clear();
      return false;
    }
    factors.matrix.values.assign(k.valuePtr(), k.valuePtr() + k.nonZeros());
    d = by_factors(factors, f);
    return factors.solver.info() == Eigen::Success && d.allFinite();
  }

  /// As they are: of the matrix that they were made of, and what is beside this one.
  template <class Solver>
  Eigen::VectorXd by_factors(Factors<Solver>& factors, const Eigen::VectorXd& f) const {
    Eigen::VectorXd d = factors.solver.solve(f);
    if (beside_.none()) return d;
    if (!factors.beside.made_for(beside_)) factors.beside.make(factors.solver, beside_);
    factors.beside.correct(d);
    return d;
  }

  template <class Solver>
  void restore(Factors<Solver>& factors, const KeptFactors::Matrix& matrix) {
    factors.matrix = matrix;
    if (!matrix.made()) return;
    if (std::ssize(matrix.values) != k.nonZeros())
      throw std::runtime_error(
          "the checkpoint holds factors of another matrix; resume with the scene of the run that wrote it, or begin a "
          "new run");
    std::copy(matrix.values.begin(), matrix.values.end(), k.valuePtr());
    factorize(factors);
  }

  /// By refinement, unless that has just failed.
  template <class Solver>
  bool serves(Factors<Solver>& factors, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    if (factors.matrix.pause.skips()) return false;
    const Stopwatch watch(times_.refinement);
    const bool served = refine(factors, f, d);
    served ? factors.matrix.pause.succeeded() : factors.matrix.pause.failed();
    return served;
  }

  template <class Solver>
  void factorize(Factors<Solver>& factors) {
    const Stopwatch watch(times_.factorization);
    const OneThread one;
    if (!factors.analysed) factors.solver.analyzePattern(k);
    factors.analysed = true;
    factors.beside.forget();
    factors.solver.factorize(k);
  }

  /// Iterative refinement with factors of a similar matrix, until the residual vanishes: false if it converges too
  /// slowly.
  template <class Solver>
  bool refine(Factors<Solver>& factors, const Eigen::VectorXd& f, Eigen::VectorXd& d) const {
    constexpr double accurate = 1e-8;
    constexpr double fast = 0.1;  // slower convergence costs more than new factors
    const double enough = accurate * f.norm();
    d = by_factors(factors, f);
    for (double last = std::numeric_limits<double>::infinity();;) {
      Eigen::VectorXd left = f - k * d;
      if (!beside_.none()) left -= product(beside_, d);
      const double size = left.norm();
      if (size <= enough) return d.allFinite();
      if (!(size <= fast * last)) return false;
      last = size;
      d += by_factors(factors, left);
    }
  }

  LowRank beside_;
  Factors<Eigen::CholmodDecomposition<Matrix>> cholesky_;
  Factors<Eigen::KLU<Matrix>> lu_;
  Factors<Eigen::UmfPackLU<Matrix>> large_lu_;
  Factors<DiagonalLu> diagonal_lu_;
  bool by_cholesky_ = false;  ///< in the last solve
  bool on_diagonal_ = false;  ///< the pivots of LU
  bool reused_ = false;
  SolutionTimes times_;
};

}  // namespace blockweir::solid
