// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that leads once more to where a run broke off, without its fluid.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// The scene as run, cut to `duration_s` (a step at least), the water's last load as given pressures on faces. What it
/// expected, its variants and its studies are left out.
std::string repeat_text(const Scene& scene, double duration_s, const std::vector<FacePressure>& in_place_of_water);

}  // namespace blockweir::scene
