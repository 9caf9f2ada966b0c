// SPDX-License-Identifier: GPL-3.0-or-later
// How a failing body separates from the rest: it slides, overturns, or both; or it lifts off or drops straight.
#pragma once

#include <string>

#include "solid/watch/moving_body.hpp"

namespace blockweir::solid {

struct Mode {
  bool turns = false;
  bool slides = false;
  bool leaves = false;  ///< its joints open everywhere, by more than they slip
  bool up = false;      ///< against gravity

  [[nodiscard]] std::string word() const {
    if (leaves) return up ? "lifting" : "falling";
    return !turns ? "sliding" : slides ? "sliding and overturning" : "overturning";
  }
};

Mode mode_of(const MovedSince& moved, const MovingBody& body, const PairMotions& pairs);

}  // namespace blockweir::solid
