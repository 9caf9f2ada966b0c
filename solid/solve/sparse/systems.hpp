// SPDX-License-Identifier: GPL-3.0-or-later
// The linear systems of this library; see SparseSolvers.
#pragma once

#include "solid/solve/linear_system.hpp"

namespace blockweir::solid {

std::unique_ptr<LinearSystem> make_sparse_system(const Unknowns& unknowns,
                                                 const std::vector<std::pair<int, int>>& couples);
std::unique_ptr<LinearSystem> make_nodal_system(const Unknowns& unknowns,
                                                const std::vector<std::pair<int, int>>& couples);

}  // namespace blockweir::solid
