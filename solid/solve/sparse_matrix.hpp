// SPDX-License-Identifier: GPL-3.0-or-later
// A sparse matrix with a pattern that stays, so that the symbolic factorization is done once: Cholesky (CHOLMOD) while
// it is symmetric, LU (UMFPACK) while contacts slip. The factors are kept, too, and serve matrices nearby.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

#include "bridge/results/stopwatch.hpp"
#include "solid/solve/linear_system.hpp"
#include "solid/solve/low_rank.hpp"
#include "solid/solve/one_thread.hpp"

namespace blockweir::solid {

class SparseMatrix {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// LU without refinement of its own: solve() refines where it has to. A matrix that is not positive definite is an
  /// answer, and no line of CHOLMOD's on the terminal.
  SparseMatrix() {
    lu_.solver.umfpackControl()[UMFPACK_IRSTEP] = 0;
    cholesky_.solver.cholmod().print = 0;
  }

  /// Zeros where the entries say.
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

  /// The next solve makes new ones.
  void forget_factors() {
    cholesky_.of = {};
    lu_.of = {};
  }

  /// Made of a matrix with this pattern, factors are those that gave `kept`, to the bit.
  [[nodiscard]] KeptFactors kept() const { return {cholesky_.of, lu_.of}; }
  void restore(const KeptFactors& kept) {
    restore(cholesky_, kept.cholesky);
    restore(lu_, kept.lu);
  }

  /// False when it is singular to working accuracy.
  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    by_cholesky_ = symmetric;
    return symmetric ? solve_with(cholesky_, f, d) : solve_with(lu_, f, d);
  }
  /// With the factors of the last solve.
  [[nodiscard]] Eigen::VectorXd solve_again(const Eigen::VectorXd& f) {
    Eigen::VectorXd d;
    by_cholesky_ ? refine(cholesky_, f, d) : refine(lu_, f, d);
    return d;
  }
  /// Did the last solve factorize nothing?
  [[nodiscard]] bool reused() const { return reused_; }
  [[nodiscard]] SolutionTimes times() const { return times_; }

  [[nodiscard]] Eigen::MatrixXd dense() const {
    Eigen::MatrixXd all = k;
    if (!beside_.none()) all += beside_.U * beside_.S * beside_.U.transpose();
    return all;
  }

  Matrix k;

 private:
  template <class Solver>
  struct Factors {
    Solver solver;
    bool analysed = false;
    KeptFactors::Matrix of;
    WoodburyCorrection beside;
  };

  template <class Solver>
  bool solve_with(Factors<Solver>& factors, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    const bool same = factors.of.made() && std::equal(factors.of.values.begin(), factors.of.values.end(), k.valuePtr());
    reused_ = same || (factors.of.made() && serves(factors, f, d));
    if (reused_) {
      if (same) d = by_factors(factors, f);
      return d.allFinite();
    }
    factorize(factors);
    if (factors.solver.info() != Eigen::Success) {
      factors.of.values.clear();
      return false;
    }
    factors.of.values.assign(k.valuePtr(), k.valuePtr() + k.nonZeros());
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
  void restore(Factors<Solver>& factors, const KeptFactors::Matrix& of) {
    factors.of = of;
    if (!of.made()) return;
    if (std::ssize(of.values) != k.nonZeros()) throw std::runtime_error("a checkpoint with factors of another matrix");
    std::copy(of.values.begin(), of.values.end(), k.valuePtr());
    factorize(factors);
  }

  /// By refinement, unless that has failed just now.
  template <class Solver>
  bool serves(Factors<Solver>& factors, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    if (factors.of.pause.skips()) return false;
    const Stopwatch watch(times_.refinement);
    const bool served = refine(factors, f, d);
    served ? factors.of.pause.succeeded() : factors.of.pause.failed();
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

  /// Solves with factors of a matrix near this one, again for what is left until nothing is: false where they serve it
  /// badly.
  template <class Solver>
  bool refine(Factors<Solver>& factors, const Eigen::VectorXd& f, Eigen::VectorXd& d) const {
    constexpr double accurate = 1e-8;
    constexpr double fast = 0.1;  // a slower one costs more than new factors
    const double enough = accurate * f.norm();
    d = by_factors(factors, f);
    for (double last = std::numeric_limits<double>::infinity();;) {
      Eigen::VectorXd left = f - k * d;
      if (!beside_.none()) left -= beside_.times(d);
      const double size = left.norm();
      if (size <= enough) return d.allFinite();
      if (!(size <= fast * last)) return false;
      last = size;
      d += by_factors(factors, left);
    }
  }

  LowRank beside_;
  Factors<Eigen::CholmodDecomposition<Matrix>> cholesky_;
  Factors<Eigen::UmfPackLU<Matrix>> lu_;
  bool by_cholesky_ = false;  ///< the last solve
  bool reused_ = false;
  SolutionTimes times_;
};

}  // namespace blockweir::solid
