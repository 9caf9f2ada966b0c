// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/schedules.hpp"

namespace blockweir::schedule {

void serial_staggered(Exchange& water, Windows& windows, SolidSide& solid) {
  wire::Motion motion;
  for (;;) {
    const bool first = water.number() == 0;
    solid.place(motion);
    water.send_and_receive(motion, windows.from_s());
    if (first) solid.start(water.load());
    if (solid.finished()) return;
    solid.advance(water.load(), water.answered(), windows.from_s(), windows.to_s());
    if (windows.last() || solid.finished()) return;
    windows.next(solid);
  }
}

}  // namespace blockweir::schedule
