// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities at a point of a block, for [[expect]] with at_m: displacement, stress, and beam theory.
#pragma once

#include <map>
#include <string>

#include "solid/watch/stress_field.hpp"

namespace blockweir::solid::expect {

/// Of block `block` at a point of the scene as drawn; displacements are measured from there.
using PointQuantity = double (*)(const Solid&, std::size_t block, const Point& point);
const std::map<std::string, PointQuantity>& point_quantities();

/// For scene block `block` under its first loads.
using PointFormula = double (*)(const scene::Scene&, const scene::Block& block, const Point& point);
const std::map<std::string, PointFormula>& point_formulas();

}  // namespace blockweir::solid::expect
