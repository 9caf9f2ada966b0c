// SPDX-License-Identifier: GPL-3.0-or-later
// Hands a script to the gnuplot program.
#pragma once

#include <string>

namespace blockweir::launch {

/// Throws std::runtime_error when gnuplot is missing or refuses the script.
void gnuplot(const std::string& script);

/// A text in double quotes as gnuplot reads it, without its markup.
std::string gnuplot_text(const std::string& text);

}  // namespace blockweir::launch
