// SPDX-License-Identifier: GPL-3.0-or-later
// Reads distribution = "normal" and its parameters, in a [[random]] or in a variable of a [[study]].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/distribution.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

/// None if the table has none, or an unknown one, which is reported.
std::optional<Distribution> read_distribution(TableReader& table, Reading& reading, bool required);

/// The keys of all distributions, except "distribution" itself.
const std::vector<std::string>& keys_of_distributions();

}  // namespace blockweir::scene
