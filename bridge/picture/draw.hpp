// SPDX-License-Identifier: GPL-3.0-or-later
// Draws pictures with the gnuplot program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

struct Picture {
  std::filesystem::path file;  ///< the suffix chooses the format: .png, .svg, or .gif for an animation
  double width;                ///< pixels
  double height;               ///< pixels
  std::string commands;        ///< for gnuplot, without terminal and output
  int letter_points = 12;      ///< font size
};

/// For scripts: reports that one more part is drawn.
inline constexpr const char* one_more_drawn = "print 'drawn'\n";

/// gnuplot's commands that draw the picture into `output`, a name chosen by the program and never by a user.
std::string gnuplot_script(const Picture& picture, const std::string& output);

/// Draws all pictures, then puts them in place together: existing files stay if one fails. Throws std::runtime_error if
/// gnuplot is missing or refuses a script, or if a file cannot be written. With `show_progress`, standard error shows
/// the progress: a bar on a terminal, a line for each tenth in a pipe.
void draw(const std::vector<Picture>& pictures, bool show_progress = false);

}  // namespace blockweir::picture
