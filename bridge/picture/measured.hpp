// SPDX-License-Identifier: GPL-3.0-or-later
// CSV of measured points: time_s, then columns of history.csv. A table that was typed or exported has slips that a
// history has not.
#pragma once

#include <filesystem>

#include "bridge/picture/history.hpp"

namespace blockweir::picture {

/// Throws std::invalid_argument with file and line where a heading comes twice, a row has more or fewer cells than the
/// heading, a cell is no finite number, or there is no point.
History read_measured(const std::filesystem::path& file);

}  // namespace blockweir::picture
