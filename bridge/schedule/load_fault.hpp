// SPDX-License-Identifier: GPL-3.0-or-later
// What a fluid has sent does not go with the scene.
#pragma once

#include <stdexcept>

namespace blockweir::schedule {

/// what() says what the fluid does wrong, as "loads block 7, which ...": who it is stands before that, and the schedule
/// knows its name.
struct LoadFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace blockweir::schedule
