// SPDX-License-Identifier: GPL-3.0-or-later
// [[study]]
#pragma once

#include <vector>

#include "bridge/scene/open_study.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

/// Call after read_studies(): a [[study]] may not reuse the names of other studies.
std::vector<OpenStudy> read_open_studies(Reading& reading);

}  // namespace blockweir::scene
