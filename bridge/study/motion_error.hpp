// SPDX-License-Identifier: GPL-3.0-or-later
// How far two runs of a scene are apart at their end.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::study {

/// Ways of all centroids until the end of a run, x and y in m, in the order of its blocks.
using Ways = std::vector<std::array<double, 2>>;
Ways ways_of(const std::filesystem::path& run);

/// Largest distance of a centroid from where the other run has it, over the farthest way of any there. Throws
/// std::runtime_error where nothing moves there.
double motion_error(const Ways& ways, const Ways& finer);

}  // namespace blockweir::study
