// SPDX-License-Identifier: GPL-3.0-or-later
// Results that are written each so many seconds of a run.
#pragma once

namespace blockweir::results {

/// Whether what comes each `every_s` is due at `time_s`, but for round-off; `next_s` is then the next time.
inline bool is_due(double time_s, double every_s, double& next_s) {
  const double soon = 1e-9 * every_s;
  if (time_s < next_s - soon) return false;
  while (next_s <= time_s + soon) next_s += every_s;
  return true;
}

}  // namespace blockweir::results
