// SPDX-License-Identifier: GPL-3.0-or-later
// A load from the fluid that does not fit the scene.
#pragma once

#include <stdexcept>

namespace blockweir::schedule {

/// what() says what is wrong, e.g. "loads block 7, which ..."; the schedule puts the fluid's name in
/// front.
struct LoadFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace blockweir::schedule
