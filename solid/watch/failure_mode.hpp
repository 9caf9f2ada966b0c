// SPDX-License-Identifier: GPL-3.0-or-later
// How a body that fails leaves what stays: it slides, turns over an edge, or both.
#pragma once

#include <string>

#include "solid/watch/moving_body.hpp"

namespace blockweir::solid {

struct Mode {
  bool turns = false;
  bool slides = false;

  [[nodiscard]] std::string word() const {
    return !turns ? "sliding" : slides ? "sliding and overturning" : "overturning";
  }
};

Mode mode_of(const MovedSince& moved, const MovingBody& body, const PairMotions& pairs);

}  // namespace blockweir::solid
