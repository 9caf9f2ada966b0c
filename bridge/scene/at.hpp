// SPDX-License-Identifier: GPL-3.0-or-later
// Eigen counts by signed numbers, and so do scenes and messages; the standard library's containers do not.
#pragma once

#include <cstddef>

namespace blockweir {

/// Index i >= 0 of a standard container.
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace blockweir
