// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of the water that flows through joints: pressures along a few of them at five times, or a map of many at the
// last time; and flows over time.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::picture {

/// Script for flow.png; empty where nothing flows through the joints of the run. `terminal` and `ending` choose PNG or
/// SVG.
std::string flow_script(const std::filesystem::path& run, const std::string& terminal, const std::string& ending);

}  // namespace blockweir::picture
