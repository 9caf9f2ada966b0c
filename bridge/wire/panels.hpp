// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a load, filled panel by panel. C++17: the OpenFOAM plugin includes this.
#pragma once

#include "bridge/wire/message.hpp"

namespace blockweir::wire {

/// Adds one panel: fractions 0 <= s_from <= s_to <= 1 along the edge, pressures [Pa] at both.
inline void add_panel(Load& load, int block, int edge, double s_from, double s_to, double p_from, double p_to) {
  load.block.push_back(static_cast<std::uint32_t>(block));
  load.edge.push_back(static_cast<std::uint32_t>(edge));
  load.s_from.push_back(s_from);
  load.s_to.push_back(s_to);
  load.pressure_from_pa.push_back(p_from);
  load.pressure_to_pa.push_back(p_to);
}

/// Takes all panels out and keeps their storage.
inline void clear_panels(Load& load) {
  load.block.clear();
  load.edge.clear();
  load.s_from.clear();
  load.s_to.clear();
  load.pressure_from_pa.clear();
  load.pressure_to_pa.clear();
  load.cracks_from = 0;
  load.breached = false;
}

}  // namespace blockweir::wire
