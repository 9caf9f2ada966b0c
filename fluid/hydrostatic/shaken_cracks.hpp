// SPDX-License-Identifier: GPL-3.0-or-later
// [water] uplift_in_shaking = "zero-where-open": water does not follow into a joint that opens as the ground shakes.
#pragma once

#include <cstddef>
#include <vector>

#include "bridge/scene/cracks.hpp"
#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::hydrostatic {

/// When the ground has come to rest: the last row of its records where these end at 0, else never (infinite); minus
/// infinity where it does not shake.
double shaking_ends_s(const scene::Scene& scene);

/// Takes the pressure off the panels of the crack, those from `first` on, whose middle the other side of the joint has
/// left by more than 1e-6 of the structure's size. `motion`: where the blocks are, as drawn about `centroids`.
void empty_open_panels(const scene::Scene& scene, const scene::Crack& crack, const std::vector<scene::Point>& centroids,
                       const wire::Motion& motion, std::size_t first, wire::Load& load);

}  // namespace blockweir::hydrostatic
