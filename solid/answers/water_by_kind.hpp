// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures of still water on the blocks as drawn, separated by their source, for pictures.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/process/sides.hpp"

namespace blockweir::solid {

/// [{"name": "open water", "panels": [[x1, y1, x2, y2, p1, p2, block], ...]}, ...] in m and Pa. Panels run along the
/// outline, with the block on their left. Names are those of the sums on a joint; kinds that do not act are left out.
/// Throws as StillWater does.
nlohmann::json water_by_kind(const scene::Scene& scene, const process::FluidMaker& make_fluid, double level_m);

}  // namespace blockweir::solid
