// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure elements in cracks: the same pressure on both faces.
#pragma once

#include <vector>

#include "bridge/scene/cracks.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/wet_edges.hpp"
#include "fluid/joints/uplift.hpp"

namespace blockweir::hydrostatic {

/// Adds elements on both faces of a crack: n for each piece, the same on both faces, and one more end at a kink of the
/// profile. Parts in `open_water` (by block, edge and place) are left out: open water loads them. So are pieces whose
/// faces have left each other, as blocks with these outlines stand now: nothing holds water between them.
void add_crack_elements(const scene::Crack& crack, const joints::Profile& profile, int elements_per_face,
                        const std::vector<std::vector<Point>>& outlines, const std::vector<WetInterval>& open_water,
                        wire::Load& load);

}  // namespace blockweir::hydrostatic
