// SPDX-License-Identifier: GPL-3.0-or-later
// The table by which programs call this library.
#include <Eigen/UmfPackSupport>

#include "solid/solve/sparse/keep_freed_memory.hpp"
#include "solid/solve/sparse/systems.hpp"
#include "solid/solve/sparse_solvers.hpp"

namespace blockweir::solid {
namespace {

bool solve_once(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& f, Eigen::VectorXd& x) {
  keep_freed_memory();
  const Eigen::UmfPackLU<Eigen::SparseMatrix<double>> lu(K);
  if (lu.info() != Eigen::Success) return false;
  x = lu.solve(f);
  return true;
}

}  // namespace

extern "C" __attribute__((visibility("default")))
const SparseSolvers blockweir_sparse_solvers{make_sparse_system, make_nodal_system, solve_once};

}  // namespace blockweir::solid
