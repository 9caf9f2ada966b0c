// SPDX-License-Identifier: GPL-3.0-or-later
// A sparse matrix with a pattern that stays, so that the symbolic factorization is done once: Cholesky (CHOLMOD) while
// it is symmetric, LU (UMFPACK) while contacts slip.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <vector>

namespace blockweir::solid {

struct SparseMatrix {
  using Matrix = Eigen::SparseMatrix<double>;

  /// Zeros where the entries say.
  void set_pattern(int size, const std::vector<Eigen::Triplet<double>>& entries) {
    k.resize(size, size);
    k.setFromTriplets(entries.begin(), entries.end());
    k.makeCompressed();
  }
  void set_zero() { std::fill_n(k.valuePtr(), k.nonZeros(), 0.0); }
  /// False when it is singular to working accuracy.
  bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    by_cholesky = symmetric;
    return symmetric ? solve_with(cholesky, cholesky_ready, f, d) : solve_with(lu, lu_ready, f, d);
  }
  /// With the factors of the last solve.
  [[nodiscard]] Eigen::VectorXd solve_again(const Eigen::VectorXd& f) const {
    if (by_cholesky) return cholesky.solve(f);
    return lu.solve(f);
  }

  Matrix k;

 private:
  template <class Solver>
  bool solve_with(Solver& solver, bool& ready, const Eigen::VectorXd& f, Eigen::VectorXd& d) {
    if (!ready) {
      solver.analyzePattern(k);
      ready = true;
    }
    solver.factorize(k);
    if (solver.info() != Eigen::Success) return false;
    d = solver.solve(f);
    return solver.info() == Eigen::Success && d.allFinite();
  }

  Eigen::CholmodDecomposition<Matrix> cholesky;
  Eigen::UmfPackLU<Matrix> lu;
  bool by_cholesky = false;  ///< the last solve
  bool cholesky_ready = false;
  bool lu_ready = false;
};

}  // namespace blockweir::solid
