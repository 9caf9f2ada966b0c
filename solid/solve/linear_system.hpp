// SPDX-License-Identifier: GPL-3.0-or-later
// K d = f for one island, in blocks (5)-(6): contact terms between blocks off the diagonal, all others on it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "solid/solve/backoff.hpp"
#include "solid/solve/low_rank.hpp"
#include "solid/solve/unknowns.hpp"

namespace blockweir::solid {

/// Seconds so far.
struct SolutionTimes {
  double factorization = 0;
  double refinement = 0;  ///< solutions with factors of a similar matrix, and failed attempts
};

/// The matrix of a factorization: factorizing it again gives the same factors to the bit.
struct KeptFactors {
  struct Matrix {
    std::vector<double> values;  ///< of the sparse matrix; empty: there are no factors
    Backoff pause;               ///< for attempts to use the factors for other matrices

    [[nodiscard]] bool made() const { return !values.empty(); }
    template <class Archive>
    void serialize(Archive& archive) {
      archive(values, pause);
    }
  };
  Matrix cholesky;
  Matrix lu;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(cholesky, lu);
  }
};

class LinearSystem {
 public:
  virtual ~LinearSystem() = default;

  virtual void set_zero() = 0;
  /// Adds to the block at local (row, column); for a rigid block, the rigid part; off the diagonal only where a couple
  /// was announced.
  virtual void add(int row, int column, const Matrix6& k) = 0;
  /// Adds U S U^T to the matrix, until set_zero().
  virtual void set_beside(LowRank beside) = 0;
  /// Factorizes the sum and solves; `symmetric` promises K = K^T, which allows Cholesky for a sparse system. False if
  /// the matrix is singular to working accuracy.
  virtual bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) = 0;
  /// Whether the last solution reused earlier factors.
  [[nodiscard]] virtual bool reused() const { return false; }
  /// LU, where it is sparse, is to look for no other pivots.
  virtual void keep_pivots_on_diagonal() {}
  /// Makes the next solution factorize again.
  virtual void forget_factors() {}
  /// Solutions depend on earlier factors, so a resumed run needs the same ones.
  [[nodiscard]] virtual KeptFactors kept_factors() const { return {}; }
  virtual void restore(const KeptFactors& /*kept*/) {}
  [[nodiscard]] virtual SolutionTimes times() const = 0;
  /// Solves for another right-hand side with the factors of the last solve.
  [[nodiscard]] virtual Eigen::VectorXd solve_again(const Eigen::VectorXd& f) = 0;
  /// The whole matrix.
  [[nodiscard]] virtual Eigen::MatrixXd dense() const = 0;
};

/// Dense for small islands, sparse for large ones. If blocks share unknowns, `unknowns` must outlive the system.
std::unique_ptr<LinearSystem> make_linear_system(const Unknowns& unknowns,
                                                 const std::vector<std::pair<int, int>>& couples);

std::unique_ptr<LinearSystem> make_dense_system(const Unknowns& unknowns);

}  // namespace blockweir::solid
