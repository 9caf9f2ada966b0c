// SPDX-License-Identifier: GPL-3.0-or-later
// What the solid did not do because the scene does not need it, and what that has saved.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Files of frames: one a frame_every_s, whatever the windows.
struct Frames {
  long written = 0;
  long not_asked_for = 0;
  double seconds = 0;  ///< in writing them

  template <class Archive>
  void serialize(Archive& archive) {
    archive(written, not_asked_for, seconds);
  }
};

/// In words, a line each. Savings are the mean time of what the run did do, times what it did not.
nlohmann::json skips(const Solid& solid, const Frames& frames);

}  // namespace blockweir::solid
