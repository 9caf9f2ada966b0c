// SPDX-License-Identifier: GPL-3.0-or-later
// An earthquake that a run has twice: as a motion of the ground, and as the constant loads that stand in for it.
#pragma once

#include <optional>

#include "bridge/scene/diagnostic.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// A warning for runs of such a scene. Static answers have the constant loads alone, and nothing to be warned of.
std::optional<Diagnostic> two_earthquakes(const Scene& scene);

}  // namespace blockweir::scene
