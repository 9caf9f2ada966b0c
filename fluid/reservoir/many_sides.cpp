// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/many_sides.hpp"

namespace blockweir::reservoir {

ManySides::ManySides(const Factors& factors, const std::vector<int>& wanted) : factors_(factors) {
  // Row j of the factors' solution depends on those of its column, all of which the elimination tree reaches from the
  // first: its parent.
  const auto& L = factors.matrixL().nestedExpression();
  std::vector<bool> needed(static_cast<std::size_t>(L.cols()), false);
  for (const int unknown : wanted) {
    Eigen::Index row = row_of(unknown);
    while (!needed[static_cast<std::size_t>(row)]) {
      needed[static_cast<std::size_t>(row)] = true;
      const Eigen::SparseMatrix<double>::InnerIterator parent(L, row);
      if (parent) row = parent.row();
    }
  }
  for (Eigen::Index row = 0; row < L.cols(); ++row) {
    if (needed[static_cast<std::size_t>(row)]) rows_.push_back(row);
  }
}

Eigen::Index ManySides::row_of(int unknown) const {
  return factors_.permutationP().indices()[unknown];
}

void ManySides::solve(Rows& x) const {
  using Column = Eigen::SparseMatrix<double>::InnerIterator;
  using Row = Eigen::Matrix<double, 1, width>;
  const auto& L = factors_.matrixL().nestedExpression();
  const auto& D = factors_.vectorD();
  for (const Eigen::Index j : rows_) {
    const Row row = x.row(j);
    if (row.isZero(0)) continue;
    for (Column entry(L, j); entry; ++entry) x.row(entry.row()) -= entry.value() * row;
  }
  for (auto j = rows_.rbegin(); j != rows_.rend(); ++j) {
    Row row = x.row(*j) / D[*j];
    for (Column entry(L, *j); entry; ++entry) row -= entry.value() * x.row(entry.row());
    x.row(*j) = row;
  }
}

}  // namespace blockweir::reservoir
