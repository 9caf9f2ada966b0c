// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary elements of the reservoir on the blocks, with the hydrostatic pressure at their nodes (9).
#pragma once

#include <vector>

#include "bridge/scene/hydrostatics.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/crest_water.hpp"

namespace blockweir::hydrostatic {

/// Adds the elements of intervals that water under a surface wets to `load`. Elements are counted from an edge's ends,
/// n to an edge, so that they stay where they are when the level moves; the one that the surface cuts keeps its wet
/// part.
void add_wet_elements(const std::vector<std::vector<Point>>& outlines, const std::vector<WetInterval>& wet,
                      const scene::Scene& scene, const Surface& surface, int elements_per_face, wire::Load& load);

}  // namespace blockweir::hydrostatic
