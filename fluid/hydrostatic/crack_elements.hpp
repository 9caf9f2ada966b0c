// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure elements in cracks: the same pressure on both faces.
#pragma once

#include <vector>

#include "bridge/scene/cracks.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/wet_edges.hpp"
#include "fluid/joints/uplift.hpp"

namespace blockweir::hydrostatic {

/// Adds both faces of the crack. Each piece has n elements, the same on both faces, and one end more where the
/// profile has a kink. What `open_water` reaches, by block, edge and place, is pressed by that alone.
void add_crack_elements(const scene::Crack& crack, const joints::Profile& profile, int elements_per_face,
                        const std::vector<WetInterval>& open_water, wire::Load& load);

}  // namespace blockweir::hydrostatic
