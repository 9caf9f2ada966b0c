// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bridge/scene/load_case.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

/// [[load_case]]. Their settings are checked by `blockweir safety` and `blockweir check`.
std::vector<LoadCase> read_load_cases(Reading& reading);

}  // namespace blockweir::scene
