// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a scene that reproduces, without a fluid, the point at which a run broke off.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// The scene as run, shortened to `duration_s` (at least one step). The water's last load becomes stated pressures on
/// faces; expectations, variants and studies are left out.
std::string repeat_text(const Scene& scene, double duration_s, const std::vector<FacePressure>& in_place_of_water);

}  // namespace blockweir::scene
