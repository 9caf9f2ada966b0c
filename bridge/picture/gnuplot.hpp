// SPDX-License-Identifier: GPL-3.0-or-later
// Words of gnuplot's language. Text of a scene reaches a script through gnuplot_text alone: in single quotes gnuplot
// runs no command and expands no macro, and all terminals are opened without markup.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace blockweir::picture {

/// A text in single quotes; control characters become spaces.
std::string gnuplot_text(const std::string& text);

/// A text as the label of a tic, which gnuplot reads as the format of a number.
std::string gnuplot_tic(std::string text);

/// At most `letters` of the text; what is longer ends in an ellipsis.
std::string shortened(const std::string& text, std::size_t letters);

/// A title in at most three lines of a picture that is `width` pixels wide; what is longer ends in an ellipsis.
std::string gnuplot_title(const std::string& text, double width);

/// A filled outline as object `number` of the next plot.
std::string gnuplot_polygon(int number, const std::vector<Eigen::Vector2d>& outline, const std::string& style);

}  // namespace blockweir::picture
