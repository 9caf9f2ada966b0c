// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the section that a picture shows [m].
#pragma once

#include <algorithm>

#include "bridge/geometry/outline.hpp"

namespace blockweir::picture {

struct View {
  double left = 1e300;
  double right = -1e300;
  double bottom = 1e300;
  double top = -1e300;

  void include(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    bottom = std::min(bottom, y);
    top = std::max(top, y);
  }
};

inline View view_of(const geometry::Bounds& bounds) {
  return {bounds.low.x(), bounds.high.x(), bounds.low.y(), bounds.high.y()};
}

}  // namespace blockweir::picture
