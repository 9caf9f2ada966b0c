// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of the water that flows through joints: pressures along a few of them at five times, or a map of many at the
// last time; and flows over time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/picture/draw.hpp"

namespace blockweir::picture {

/// `flow`; none where nothing flows through the joints of the run. `ending` chooses PNG or SVG.
std::vector<Picture> flow_picture(const std::filesystem::path& run, const std::string& ending);

}  // namespace blockweir::picture
