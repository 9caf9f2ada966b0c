// SPDX-License-Identifier: GPL-3.0-or-later
// The difference between two runs of a scene at their end.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::study {

/// Displacements of all centroids at the end of a run, x and y in m, in the order of the run's blocks.
using Ways = std::vector<std::array<double, 2>>;
Ways ways_of(const std::filesystem::path& run);

/// Largest distance between a centroid in the two runs, over the largest displacement in `finer`. Throws
/// std::runtime_error if nothing moves there.
double motion_error(const Ways& ways, const Ways& finer);

}  // namespace blockweir::study
