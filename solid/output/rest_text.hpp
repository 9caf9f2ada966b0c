// SPDX-License-Identifier: GPL-3.0-or-later
// What a static analysis came to, in words.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"
#include "solid/step/counts.hpp"

namespace blockweir::solid::output {

/// `steps`: of the whole analysis; `farthest_m`: largest displacement of a vertex at its end.
std::string rest_text(const Rest& rest, long steps, const scene::Analysis& analysis, double farthest_m);

}  // namespace blockweir::solid::output
