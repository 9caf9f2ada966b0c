// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/schedules.hpp"

namespace blockweir::schedule {

void begin(Exchange& water, Windows& windows, SolidSide& solid) {
  if (water.number() > 0) return;
  wire::Motion motion;
  solid.place(motion);
  water.send_and_receive(motion, windows.from_s());
  solid.start(water.load());
}

void improved_staggered(Exchange& water, Windows& windows, SolidSide& solid) {
  wire::Motion motion;
  begin(water, windows, solid);
  while (!solid.finished()) {
    const double half = (windows.to_s() - windows.from_s()) / 2;
    solid.predict(half, motion);
    water.send_and_receive(motion, windows.from_s() + half);
    solid.advance(water.load(), water.answered(), windows.from_s(), windows.to_s());
    if (windows.last()) return;
    windows.next(solid);
  }
}

}  // namespace blockweir::schedule
