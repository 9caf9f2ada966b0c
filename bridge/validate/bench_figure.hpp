// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a bench.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/validate/pareto.hpp"

namespace blockweir::study {

/// Error over wall time, both logarithmic: a line for each curve, the Pareto front, a star for the scene itself.
/// `error` names the quantity.
void draw_bench(const std::filesystem::path& file, const std::string& title, const std::string& error,
                const std::vector<Point>& points);

}  // namespace blockweir::study
