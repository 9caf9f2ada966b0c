// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/complementarity.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace blockweir::solid {
namespace {

/// Rows: basic variables; columns: w, z, the artificial variable that covers what is negative of q, and values.
class Tableau {
 public:
  Tableau(const Eigen::MatrixXd& M, const Eigen::VectorXd& q) : n_(M.rows()), cells_(n_, 2 * n_ + 2) {
    cells_ << Eigen::MatrixXd::Identity(n_, n_), -M, Eigen::VectorXd::Constant(n_, -1), q;
    for (Eigen::Index i = 0; i < n_; ++i) basic_.push_back(i);
  }
  [[nodiscard]] Eigen::Index artificial() const { return 2 * n_; }
  [[nodiscard]] Eigen::Index complement(Eigen::Index variable) const {
    return variable < n_ ? variable + n_ : variable - n_;
  }
  /// The basic variable of the row leaves.
  Eigen::Index exchange(Eigen::Index row, Eigen::Index entering) {
    cells_.row(row) /= cells_(row, entering);
    for (Eigen::Index i = 0; i < n_; ++i) {
      const double factor = cells_(i, entering);
      if (i != row && factor != 0) cells_.row(i) -= factor * cells_.row(row);
    }
    return std::exchange(basic_[static_cast<std::size_t>(row)], entering);
  }
  /// Row of the variable that gets to zero first as another grows; the artificial one if it does as soon. -1: none
  /// does.
  [[nodiscard]] Eigen::Index first_to_vanish(Eigen::Index entering) const {
    constexpr double smallest_pivot = 1e-10;
    constexpr double tie = 1e-12;
    double least = std::numeric_limits<double>::infinity();
    Eigen::Index found = -1;
    for (Eigen::Index i = 0; i < n_; ++i) {
      if (cells_(i, entering) <= smallest_pivot) continue;
      const double ratio = cells_(i, artificial() + 1) / cells_(i, entering);
      const bool ends = basic_[static_cast<std::size_t>(i)] == artificial();
      if (ratio < least - tie || (ends && ratio <= least + tie)) {
        least = std::min(least, ratio);
        found = i;
      }
    }
    return found;
  }
  [[nodiscard]] Eigen::VectorXd z() const {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(n_);
    for (Eigen::Index i = 0; i < n_; ++i) {
      const Eigen::Index variable = basic_[static_cast<std::size_t>(i)];
      if (variable >= n_ && variable < 2 * n_) values[variable - n_] = std::max(0.0, cells_(i, artificial() + 1));
    }
    return values;
  }

 private:
  Eigen::Index n_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> cells_;
  std::vector<Eigen::Index> basic_;
};

}  // namespace

std::optional<Eigen::VectorXd> solve_complementarity(const Eigen::MatrixXd& M, const Eigen::VectorXd& q) {
  Eigen::Index worst = 0;
  if (q.size() == 0 || q.minCoeff(&worst) >= 0) return Eigen::VectorXd::Zero(q.size());
  Tableau tableau(M, q);
  Eigen::Index left = tableau.exchange(worst, tableau.artificial());
  for (Eigen::Index pivots = 0; pivots < 3 * q.size(); ++pivots) {
    const Eigen::Index entering = tableau.complement(left);
    const Eigen::Index row = tableau.first_to_vanish(entering);
    if (row < 0) return std::nullopt;
    left = tableau.exchange(row, entering);
    if (left == tableau.artificial()) return tableau.z();
  }
  return std::nullopt;
}

}  // namespace blockweir::solid
