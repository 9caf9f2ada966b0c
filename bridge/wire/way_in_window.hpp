// SPDX-License-Identifier: GPL-3.0-or-later
// Where a block is within a window whose ends messages have told. C++17: the OpenFOAM plugin includes this.
#pragma once

namespace blockweir::wire {

/// On the cubic that leaves `start` at `from` and arrives `way` farther at `to`, rates per window, after `part` of it.
/// With straight pieces all of a window's acceleration would fall into its first step.
inline double way_in_window(double start, double way, double from, double to, double part) {
  return start + part * (from + part * (3 * way - 2 * from - to + part * (from + to - 2 * way)));
}

}  // namespace blockweir::wire
