// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures of a mesh that was left, on the mesh that follows it.
#pragma once

#include "fluid/reservoir/answering_water.hpp"

namespace blockweir::reservoir {

/// Interpolates the state of the meshes `from` at the nodes of `to`; outside them, extrapolates from the edge of the
/// nearest triangle. The ground has moved by ground_m since, and the water with it.
PressureState carry_over(const std::vector<AnsweringWater>& from, const WaterMesh& to, const Point& ground_m);

}  // namespace blockweir::reservoir
