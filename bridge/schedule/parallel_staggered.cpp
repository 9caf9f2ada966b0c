// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/schedule/schedules.hpp"

namespace blockweir::schedule {

void parallel_staggered(Exchange& water, Windows& windows, SolidSide& solid) {
  wire::Motion motion;
  begin(water, windows, solid);
  while (!solid.finished()) {
    const bool last = windows.last();  // nobody would hear its pressures
    if (!last) {
      solid.predict(windows.to_s() - windows.from_s(), motion);
      water.send(motion, windows.to_s());
    } else {
      solid.record();
    }
    solid.advance(water.load(), water.answered(), windows.from_s(), windows.to_s());
    if (last) return;
    water.receive();
    windows.next(solid);
  }
}

}  // namespace blockweir::schedule
