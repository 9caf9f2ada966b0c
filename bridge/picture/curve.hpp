// SPDX-License-Identifier: GPL-3.0-or-later
// Thins a curve for a picture: gnuplot reads text slowly, and a picture has fewer pixels than a history has rows.
#pragma once

#include <string>
#include <vector>

namespace blockweir::picture {

/// Rows "x y" for gnuplot. From each of `spans` equal spans of x it takes the rows with the lowest and highest y, in
/// order, and the last row of all; a blank line where y is no number. `factor` multiplies y. `x` is ascending.
std::string curve_rows(const std::vector<double>& x, const std::vector<double>& y, std::size_t spans,
                       double factor = 1);

}  // namespace blockweir::picture
