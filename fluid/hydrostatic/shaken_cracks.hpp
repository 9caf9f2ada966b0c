// SPDX-License-Identifier: GPL-3.0-or-later
// [water] uplift_in_shaking = "zero-where-open": no water flows into a joint that opens while the ground shakes.
#pragma once

#include <cstddef>
#include <vector>

#include "bridge/scene/cracks.hpp"
#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::hydrostatic {

/// Time at which the ground comes to rest: the last row of its records if these end at 0, otherwise infinite; minus
/// infinity if the ground does not shake.
double shaking_ends_s(const scene::Scene& scene);

/// Removes the pressure of those panels of the crack (from `first` on) whose middle is more than 1e-6 of the
/// structure's size away from the other side of the joint. `motion`: positions of the blocks, drawn about `centroids`.
void empty_open_panels(const scene::Scene& scene, const scene::Crack& crack, const std::vector<scene::Point>& centroids,
                       const wire::Motion& motion, std::size_t first, wire::Load& load);

}  // namespace blockweir::hydrostatic
