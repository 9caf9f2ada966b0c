// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of gnuplot's language. Text of a scene enters a script only through gnuplot_text: inside single quotes
// gnuplot runs no command and expands no macro, and all terminals are opened without markup.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// A text in single quotes; control characters become spaces.
std::string gnuplot_text(const std::string& text);

/// A text as the label of a tic mark, which gnuplot reads as a number format.
std::string gnuplot_tic(std::string text);

/// The first `letters` of the text; a longer text ends in an ellipsis.
std::string shortened(const std::string& text, std::size_t letters);

/// A title of at most three lines in a picture `width` pixels wide; a longer one ends in an ellipsis.
std::string gnuplot_title(const std::string& text, double width);

/// What of an outline is in view, as filled objects of the next plot. `number`: of the last object, counted on. gnuplot
/// itself moves vertices that lie beyond the view to its edge, which bends the outline.
std::string gnuplot_polygon(int& number, const std::vector<Eigen::Vector2d>& outline, const View& view,
                            const std::string& style);

}  // namespace blockweir::picture
