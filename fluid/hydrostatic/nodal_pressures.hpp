// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary elements of the reservoir on the blocks, with the hydrostatic pressure at their nodes (9).
#pragma once

#include <vector>

#include "bridge/scene/hydrostatics.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/crest_water.hpp"

namespace blockweir::hydrostatic {

/// Adds to `load` the elements of intervals that water with this surface wets. Elements are counted from the ends of an
/// edge, n for each edge, so that they do not move when the level does; an element cut by the surface keeps its wet
/// part.
void add_wet_elements(const std::vector<std::vector<Point>>& outlines, const std::vector<WetInterval>& wet,
                      const scene::Scene& scene, const Surface& surface, int elements_per_face, wire::Load& load);

}  // namespace blockweir::hydrostatic
