// SPDX-License-Identifier: GPL-3.0-or-later
// The schedules, each from the start, or from where a run is resumed, to the end of the last window. T_k is the time of
// motion k and of the pressures that answer it; w_n the window from t_n to t_n+1.
#pragma once

#include "bridge/schedule/exchange.hpp"

namespace blockweir::schedule {

/// Conventional serial staggered: T_n = t_n. The solid steps over w_n under p_n, then the fluid to t_n+1 with the
/// blocks where they have come to.
void serial_staggered(Exchange& water, Windows& windows, SolidSide& solid);

/// Parallel explicit: T_n = t_n. The solid steps over w_n under p_n while the fluid steps to t_n+1 with the blocks
/// where they would come to by themselves.
void parallel_staggered(Exchange& water, Windows& windows, SolidSide& solid);

/// Improved serial staggered (Lesoinne and Farhat 1998): T_n+1 in the middle of w_n. The fluid is half a window ahead,
/// with the blocks where they would come to; the solid steps over the whole window under the pressure of its middle.
void improved_staggered(Exchange& water, Windows& windows, SolidSide& solid);

/// Pressures of time 0, where no run is resumed: the solid settles under them.
void begin(Exchange& water, Windows& windows, SolidSide& solid);

}  // namespace blockweir::schedule
