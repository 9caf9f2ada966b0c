// SPDX-License-Identifier: GPL-3.0-or-later
// What a joint is called to which the scene gives no name.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// "a on b": b is the one that is fixed, else the one whose centroid is lower, else the one further right. In whichever
/// order blocks are given or stand in the scene.
std::string unnamed_joint(const Scene& scene, int one, int other);

}  // namespace blockweir::scene
