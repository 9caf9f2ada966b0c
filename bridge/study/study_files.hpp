// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of studies.
#pragma once

#include <filesystem>
#include <string>

namespace blockweir::study {

/// Draws gnuplot's commands, without terminal and output, and prints the file's path.
void draw_study(const std::filesystem::path& file, const std::string& title, const std::string& figure);

}  // namespace blockweir::study
