// SPDX-License-Identifier: GPL-3.0-or-later
// What the search for contacts asks of the corners of an outline.
#pragma once

#include <cstddef>

#include "solid/block/block.hpp"

namespace blockweir::solid {

constexpr double parallel_tolerance = 0.05;  // rad; edges closer in direction than this lie on each other

inline double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

inline std::size_t next(std::size_t i, std::size_t count) {
  return i + 1 == count ? 0 : i + 1;
}
inline std::size_t previous(std::size_t i, std::size_t count) {
  return i == 0 ? count - 1 : i - 1;
}

}  // namespace blockweir::solid
