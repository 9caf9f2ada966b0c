// SPDX-License-Identifier: GPL-3.0-or-later
// Work that the solid skipped because the scene does not need it, and the time saved.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Frame files: one every frame_every_s, independent of the windows.
struct Frames {
  long written = 0;
  long windows_without = 0;
  double seconds = 0;  ///< for writing them

  template <class Archive>
  void serialize(Archive& archive) {
    archive(written, windows_without, seconds);
  }
};

/// As text, one line each. Savings are the mean time of the work done, times the number skipped.
nlohmann::json skips(const Solid& solid, const Frames& frames);

}  // namespace blockweir::solid
