// SPDX-License-Identifier: GPL-3.0-or-later
// Fills in the motion message from the solid.
#pragma once

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Displacements and velocities after `ahead_s`, at constant acceleration; not number, time and order. Velocities for
/// water that answers ahead are those of scene::velocities_ahead_s instead.
void fill_motion(const Solid& solid, double ahead_s, wire::Motion& motion);

}  // namespace blockweir::solid
