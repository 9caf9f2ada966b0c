// SPDX-License-Identifier: GPL-3.0-or-later
// Response spectrum: the largest response of an oscillator on shaking ground, by its period.
#pragma once

#include <vector>

#include "bridge/scene/time_table.hpp"

namespace blockweir::picture {

/// Largest pseudo-acceleration omega^2 |x| [m/s2] of x'' + 2 zeta omega x' + omega^2 x = -a(t), from rest at time 0,
/// during `duration_s` and one period after it. Exact for accelerations that are linear between rows (Nigam and
/// Jennings 1969).
double pseudo_acceleration(const scene::TimeTable& a, double duration_s, double period_s, double damping_ratio);

}  // namespace blockweir::picture
