// SPDX-License-Identifier: GPL-3.0-or-later
// How blocks move, as the fluid is told.
#pragma once

#include "bridge/wire/message.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Displacements and velocities `ahead_s` from now, accelerations as they are; all but number, time and order.
void tell_motion(const Solid& solid, double ahead_s, wire::Motion& motion);

}  // namespace blockweir::solid
