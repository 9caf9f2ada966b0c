// SPDX-License-Identifier: GPL-3.0-or-later
// Hands a script to the gnuplot program.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

/// Throws std::runtime_error when gnuplot is missing or refuses the script.
void gnuplot(const std::string& script);

/// A text in double quotes as gnuplot reads it, without its markup.
std::string gnuplot_text(const std::string& text);

/// A file's path in quotes as gnuplot reads it.
std::string gnuplot_path(const std::filesystem::path& path);

/// A filled outline as object `number` of the next plot.
std::string gnuplot_polygon(int number, const std::vector<Eigen::Vector2d>& outline, const std::string& style);

}  // namespace blockweir::picture
