// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing of loads: diagrams along edges, arrows and colours, the same in figures and in the report.
#pragma once

#include <nlohmann/json.hpp>

namespace blockweir::picture {

constexpr const char* bolt_colour = "#b03060";

/// Adds to each entry of acting_loads: colour; diagrams, outlines in m on the loaded side, each kind with its own
/// scale; arrow [[x, y], [x, y]], the resultant, which ends at its point; label, its name and size; labelled,
/// whether a picture has that label. Loads of a kind that meet have one scale. Upstream of the structure, the diagrams
/// of several kinds are drawn side by side.
void add_diagrams(nlohmann::json& loads, double size_m);

/// Rows of the legend: label and colour; loads with the same name share a row, as do more than four
/// joints with uplift, which gives their sum.
[[nodiscard]] nlohmann::json load_legend(const nlohmann::json& loads);

}  // namespace blockweir::picture
