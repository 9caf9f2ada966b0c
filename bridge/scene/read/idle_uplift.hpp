// SPDX-License-Identifier: GPL-3.0-or-later
// Drains and piezometers of the file that a law set by --set, or by a load case, does not take.
#pragma once

#include <toml++/toml.h>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Who sets another law cannot leave out what the file says: it is left out here, with a warning. Only where the law is
/// set and the keys are the file's own: else they contradict each other.
void leave_out_idle_uplift(toml::table& file, Problems& problems);

}  // namespace blockweir::scene
