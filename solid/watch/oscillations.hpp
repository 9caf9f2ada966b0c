// SPDX-License-Identifier: GPL-3.0-or-later
// What may move to and fro without a failure.
#pragma once

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Blocks, contact springs or bolts that strain. Where there are none, what moves is no oscillation.
[[nodiscard]] bool anything_strains(const Solid& solid);

/// Whether velocities along directions that contacts hold may flip from step to step.
[[nodiscard]] bool velocities_ring(const Solid& solid);

}  // namespace blockweir::solid
