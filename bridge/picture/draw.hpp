// SPDX-License-Identifier: GPL-3.0-or-later
// Draws pictures with the gnuplot program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

struct Picture {
  std::filesystem::path file;  ///< its ending says what it is: .png, .svg, or .gif for an animation
  double width;                ///< pixels
  double height;               ///< pixels
  std::string commands;        ///< gnuplot's, without terminal and output
  int letter_points = 12;      ///< size of the letters
};

/// In a script: what is drawn so far counts as one more of all.
inline constexpr const char* one_more_drawn = "print 'drawn'\n";

/// gnuplot's commands for the picture, drawn into `output`, which is written by us and never by a user.
std::string gnuplot_script(const Picture& picture, const std::string& output);

/// Puts each picture in its place once all are whole: a file that was there stays where something fails. Throws
/// std::runtime_error when gnuplot is missing or refuses a script, and when a file cannot be written. With `told`,
/// standard error shows how much is drawn: a bar on a terminal, a line each tenth in a pipe.
void draw(const std::vector<Picture>& pictures, bool told = false);

}  // namespace blockweir::picture
