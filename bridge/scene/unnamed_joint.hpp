// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a joint that the scene does not name.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// "a on b", where b is the fixed block; otherwise the one with the lower centroid; otherwise the one further right.
/// The order of the arguments and of the blocks in the scene does not matter.
std::string unnamed_joint(const Scene& scene, int one, int other);

}  // namespace blockweir::scene
