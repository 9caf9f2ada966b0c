// SPDX-License-Identifier: GPL-3.0-or-later
// [[random]], [[correlation]] and [reliability]
#pragma once

#include "bridge/scene/randomness.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

Randomness read_randomness(Reading& reading);

}  // namespace blockweir::scene
