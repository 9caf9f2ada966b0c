// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures of a mesh that was left, on the mesh that follows it.
#pragma once

#include "fluid/reservoir/answering_water.hpp"

namespace blockweir::reservoir {

/// State of `to` as `from` have it, by their shape functions: where a node of `to` lies outside all of them, as they
/// are continued from the nearest triangle's edge.
PressureState carry_over(const std::vector<AnsweringWater>& from, const WaterMesh& to);

}  // namespace blockweir::reservoir
