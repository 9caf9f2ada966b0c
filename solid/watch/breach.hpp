// SPDX-License-Identifier: GPL-3.0-or-later
// When open water first passed the structure, and how high it and the crest were then.
#pragma once

namespace blockweir::solid {

struct Breach {
  double time_s = 0;
  double level_m = 0;  ///< the higher pool's; NaN without one
  double crest_m = 0;  ///< highest point of the blocks

  template <class Archive>
  void serialize(Archive& archive) {
    archive(time_s, level_m, crest_m);
  }
};

}  // namespace blockweir::solid
