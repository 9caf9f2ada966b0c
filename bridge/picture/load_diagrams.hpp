// SPDX-License-Identifier: GPL-3.0-or-later
// How loads are drawn: diagrams along edges, arrows, colours; the same in figures and in the report.
#pragma once

#include <nlohmann/json.hpp>

namespace blockweir::picture {

constexpr const char* bolt_colour = "#b03060";

/// Adds to each of acting_loads' entries: colour; diagrams, outlines in m on the outer side of what they press on, each
/// kind to a scale of its own; arrow [[x, y], [x, y]], the resultant, which ends at its point; label, its name and
/// size. Upstream of the structure, kinds beside the water stand beside it.
void add_diagrams(nlohmann::json& loads, double size_m);

/// A row of the legend each: label and colour; loads of one name share one.
[[nodiscard]] nlohmann::json load_legend(const nlohmann::json& loads);

}  // namespace blockweir::picture
