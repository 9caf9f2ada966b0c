// SPDX-License-Identifier: GPL-3.0-or-later
// K d = f of one island in blocks (5)-(6): contact terms between blocks off the diagonal, all else on it.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "solid/solve/low_rank.hpp"
#include "solid/solve/pause.hpp"
#include "solid/solve/unknowns.hpp"

namespace blockweir::solid {

/// Seconds so far.
struct SolutionTimes {
  double factorization = 0;
  double refinement = 0;  ///< solutions with factors of a matrix nearby, and tries that failed
};

/// What factors were made of: who factorizes it again has them to the bit.
struct KeptFactors {
  struct Matrix {
    std::vector<double> values;  ///< of the sparse matrix; none: there are no factors
    Pause pause;                 ///< in trying other matrices with them

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
  /// Adds to the block at local (row, column), of a rigid block the rigid part; off the diagonal only where a couple
  /// was announced.
  virtual void add(int row, int column, const Matrix6& k) = 0;
  /// The matrix is what was added and U S U^T beside it, until set_zero().
  virtual void set_beside(LowRank beside) = 0;
  /// Factorizes what was added and solves; `symmetric` promises K = K^T, which lets a sparse system use Cholesky.
  /// False when the matrix is singular to working accuracy.
  virtual bool solve(bool symmetric, const Eigen::VectorXd& f, Eigen::VectorXd& d) = 0;
  /// Did the last solution take the factors of an earlier one?
  [[nodiscard]] virtual bool reused() const { return false; }
  /// The next solution factorizes anew.
  virtual void forget_factors() {}
  /// Solutions depend on the factors of those before: a run that is resumed is to have the same.
  [[nodiscard]] virtual KeptFactors kept_factors() const { return {}; }
  virtual void restore(const KeptFactors& /*kept*/) {}
  [[nodiscard]] virtual SolutionTimes times() const = 0;
  /// For another right-hand side, with the factors of the last solve.
  [[nodiscard]] virtual Eigen::VectorXd solve_again(const Eigen::VectorXd& f) = 0;
  /// What was added, all of it.
  [[nodiscard]] virtual Eigen::MatrixXd dense() const = 0;
};

/// Dense for small islands, sparse above. Where blocks share unknowns, these must outlive the system.
std::unique_ptr<LinearSystem> make_linear_system(const Unknowns& unknowns,
                                                 const std::vector<std::pair<int, int>>& couples);

std::unique_ptr<LinearSystem> make_dense_system(const Unknowns& unknowns);
std::unique_ptr<LinearSystem> make_sparse_system(const Unknowns& unknowns,
                                                 const std::vector<std::pair<int, int>>& couples);
std::unique_ptr<LinearSystem> make_nodal_system(const Unknowns& unknowns,
                                                const std::vector<std::pair<int, int>>& couples);

}  // namespace blockweir::solid
