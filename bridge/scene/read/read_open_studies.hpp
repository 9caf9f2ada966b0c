// SPDX-License-Identifier: GPL-3.0-or-later
// [[study]]
#pragma once

#include <vector>

#include "bridge/scene/open_study.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

/// After read_studies(), whose names they may not have.
std::vector<OpenStudy> read_open_studies(Reading& reading);

}  // namespace blockweir::scene
