// SPDX-License-Identifier: GPL-3.0-or-later
// Results that are written at a fixed interval of simulated time.
#pragma once

namespace blockweir::results {

/// Whether a result with the interval `every_s` is due at `time_s`, to round-off; if so, advances `next_s`.
inline bool is_due(double time_s, double every_s, double& next_s) {
  const double soon = 1e-9 * every_s;
  if (time_s < next_s - soon) return false;
  while (next_s <= time_s + soon) next_s += every_s;
  return true;
}

}  // namespace blockweir::results
