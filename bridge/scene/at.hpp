// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a signed index, as Eigen, scenes and messages use it, into an index of a standard container.
#pragma once

#include <cstddef>

namespace blockweir {

/// `i` >= 0 as an index of a standard container.
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace blockweir
