// SPDX-License-Identifier: GPL-3.0-or-later
// The coupling schedules. Each runs from the start, or from the motion at which a run is resumed, to the end of the
// last window. T_k is the time of motion k and of its pressures; w_n is the window from t_n to t_n+1.
#pragma once

#include "bridge/schedule/exchange.hpp"

namespace blockweir::schedule {

/// Conventional serial staggered: T_n = t_n. The solid steps over w_n under p_n; then the fluid steps to t_n+1 with the
/// new positions of the blocks.
void serial_staggered(Exchange& water, Windows& windows, SolidSide& solid);

/// Parallel explicit: T_n = t_n. The solid steps over w_n under p_n; at the same time the fluid steps to t_n+1 with
/// predicted positions of the blocks.
void parallel_staggered(Exchange& water, Windows& windows, SolidSide& solid);

/// Improved serial staggered (Lesoinne and Farhat 1998): T_n+1 is the middle of w_n. The fluid is half a window ahead
/// and uses predicted positions; the solid steps over the whole window under the pressure at its middle.
void improved_staggered(Exchange& water, Windows& windows, SolidSide& solid);

/// Exchanges the pressures of time 0, unless the run is resumed; the solid settles under them.
void begin(Exchange& water, Windows& windows, SolidSide& solid);

}  // namespace blockweir::schedule
