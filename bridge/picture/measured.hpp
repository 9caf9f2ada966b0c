// SPDX-License-Identifier: GPL-3.0-or-later
// CSV of measured points: time_s, then columns of history.csv. Unlike a history, a table typed or exported by hand may
// contain mistakes.
#pragma once

#include <filesystem>

#include "bridge/picture/history.hpp"

namespace blockweir::picture {

/// Throws std::invalid_argument with file and line if a heading is repeated, a row has more or fewer cells than the
/// heading, a cell is not a finite number, or there is no point.
History read_measured(const std::filesystem::path& file);

}  // namespace blockweir::picture
