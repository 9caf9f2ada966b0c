// SPDX-License-Identifier: GPL-3.0-or-later
// Figures over time, from history.csv.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bridge/picture/plot.hpp"

namespace blockweir::picture {

/// Scripts for displacements, velocities, rotations and level; `terminal` and `ending` choose PNG or SVG.
std::string series_script(const PlotOptions& options, const nlohmann::json& summary, const std::string& terminal,
                          const std::string& ending);

}  // namespace blockweir::picture
