// SPDX-License-Identifier: GPL-3.0-or-later
// A curve as a picture shows it: gnuplot reads text slowly, and a picture has fewer pixels than a history has rows.
#pragma once

#include <string>
#include <vector>

namespace blockweir::picture {

/// Rows "x y" for gnuplot. Of each of `spans` equal spans of x those with the lowest and the highest y, in their order,
/// and the last of all; a blank line where y is no number. `factor` multiplies y. `x` ascends.
std::string curve_rows(const std::vector<double>& x, const std::vector<double>& y, std::size_t spans,
                       double factor = 1);

}  // namespace blockweir::picture
