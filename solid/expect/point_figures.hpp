// SPDX-License-Identifier: GPL-3.0-or-later
// Figures at a point of a block that [[expect]] can name with at_m: displacement, stress, and what beam theory says.
#pragma once

#include <map>
#include <string>

#include "solid/watch/stress_field.hpp"

namespace blockweir::solid::expect {

/// Of block `block` at a point of the scene's outline; displacements since that outline.
using PointQuantity = double (*)(const Solid&, std::size_t block, const Point& point);
const std::map<std::string, PointQuantity>& point_quantities();

/// Of scene block `block`, under its first loads.
using PointFormula = double (*)(const scene::Scene&, const scene::Block& block, const Point& point);
const std::map<std::string, PointFormula>& point_formulas();

}  // namespace blockweir::solid::expect
