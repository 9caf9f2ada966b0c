// SPDX-License-Identifier: GPL-3.0-or-later
// Nodal forces of a linear pressure on a straight element (10).
#pragma once

#include <array>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid {

/// Forces [N per metre] at the two nodes of an element of length d [m] under pressures p_from, p_to [Pa].
/// lumped, as published: P_i d/2 keeps the force and errs in the moment by 1/N^2 over N elements;
/// consistent: d (2 P_i + P_j)/6 keeps both.
inline std::array<double, 2> nodal_forces(scene::NodalRule rule, double length_m, double p_from_pa, double p_to_pa) {
  if (rule == scene::NodalRule::lumped) return {p_from_pa * length_m / 2, p_to_pa * length_m / 2};
  return {length_m * (2 * p_from_pa + p_to_pa) / 6, length_m * (p_from_pa + 2 * p_to_pa) / 6};
}

}  // namespace blockweir::solid
