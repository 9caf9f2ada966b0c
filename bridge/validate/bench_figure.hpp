// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a bench.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/validate/pareto.hpp"

namespace blockweir::study {

/// Error over wall time, both logarithmic: a line a curve, the Pareto front, the scene as it stands as a star. `error`
/// says what it is of.
void draw_bench(const std::filesystem::path& file, const std::string& title, const std::string& error,
                const std::vector<Point>& points);

}  // namespace blockweir::study
