// SPDX-License-Identifier: GPL-3.0-or-later
// Hands a script to the gnuplot program.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

/// Throws std::runtime_error when gnuplot is missing or refuses the script. With `told`, standard error shows how much
/// of it is drawn: a bar on a terminal, a line each tenth in a pipe.
void gnuplot(const std::string& script, bool told = false);

/// A text in double quotes as gnuplot reads it, without its markup.
std::string gnuplot_text(const std::string& text);

/// A file's path in quotes as gnuplot reads it.
std::string gnuplot_path(const std::filesystem::path& path);

/// A filled outline as object `number` of the next plot.
std::string gnuplot_polygon(int number, const std::vector<Eigen::Vector2d>& outline, const std::string& style);

}  // namespace blockweir::picture
