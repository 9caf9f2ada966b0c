// SPDX-License-Identifier: GPL-3.0-or-later
// What the shared library blockweir_sparse does: SuiteSparse's solvers, apart, as loading them takes a tenth of a small
// run, which is dense throughout.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {

struct SparseSolvers {
  using Couples = std::vector<std::pair<int, int>>;

  /// Of blocks with unknowns of their own.
  std::unique_ptr<LinearSystem> (*make_sparse_system)(const Unknowns&, const Couples&);
  /// Of blocks that share unknowns, which must outlive the system.
  std::unique_ptr<LinearSystem> (*make_nodal_system)(const Unknowns&, const Couples&);
  /// Solves K x = f once, by LU; false if K is singular to working accuracy.
  bool (*solve_once)(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& f, Eigen::VectorXd& x);
};

/// Opens the library at the first call. Throws std::runtime_error if it cannot be opened.
const SparseSolvers& sparse_solvers();

}  // namespace blockweir::solid
