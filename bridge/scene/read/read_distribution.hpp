// SPDX-License-Identifier: GPL-3.0-or-later
// distribution = "normal", and the keys that say how wide it is: of a [[random]], and of a variable of a [[study]].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/distribution.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

/// None where the table has none, or an unknown one, which is told where it stands.
std::optional<Distribution> read_distribution(TableReader& table, Reading& reading, bool required);

/// All keys that some distribution has, but for "distribution" itself.
const std::vector<std::string>& keys_of_distributions();

}  // namespace blockweir::scene
