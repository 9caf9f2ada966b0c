// SPDX-License-Identifier: GPL-3.0-or-later
// Limit analysis by linear programming (static theorem): forces at the two ends of each face between convex bodies,
// normal ones not below what the joint bears in tension, shear within Mohr-Coulomb's cone, that balance every body. The
// level at which they cease to exist is an upper bound of the level at which bodies with Coulomb friction fail, and is
// that level where forces follow from equilibrium alone.
#pragma once

#include <optional>

#include "tests/independent/structure.hpp"

namespace blockweir::independent {

struct Limit {
  double level_m = 0;
  std::vector<Eigen::Vector3d> velocities;  ///< of the mechanism, relative: x, y of the centroid, spin times size
};

/// Largest factor on the reservoir's forces at this level that can be borne; nothing where the weight alone cannot.
std::optional<double> reservoir_factor(const Structure& structure, double level_m);

/// The level at which that factor is 1, sought above `low_m` and up to `high_m`; nothing where it is not between.
std::optional<Limit> limit_level(const Structure& structure, double low_m, double high_m);

}  // namespace blockweir::independent
