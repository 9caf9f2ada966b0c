// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/sparse_solvers.hpp"

#include "bridge/results/shared_library.hpp"

namespace blockweir::solid {

const SparseSolvers& sparse_solvers() {
  static const auto* const solvers =
      static_cast<const SparseSolvers*>(results::symbol_of("libblockweir_sparse.so", "blockweir_sparse_solvers"));
  return *solvers;
}

}  // namespace blockweir::solid
