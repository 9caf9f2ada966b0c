// SPDX-License-Identifier: GPL-3.0-or-later
// Meshed blocks before compressible water, which answers their mean motion alone.
#pragma once

#include <string>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// What a wet block with a mesh lacks of its water. Empty where the water answers nothing, or no such block moves.
std::string mesh_before_sound_warning(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
