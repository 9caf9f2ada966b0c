// SPDX-License-Identifier: GPL-3.0-or-later
// Figures over time, from history.csv.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/picture/draw.hpp"
#include "bridge/picture/plot.hpp"

namespace blockweir::picture {

/// Displacements, velocities, rotations and level; `ending` chooses PNG or SVG.
std::vector<Picture> series_pictures(const PlotOptions& options, const nlohmann::json& summary,
                                     const std::string& ending);

}  // namespace blockweir::picture
