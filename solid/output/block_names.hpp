// SPDX-License-Identifier: GPL-3.0-or-later
// Names of blocks in a sentence.
#pragma once

#include <string>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid::output {

/// "block "a"", "blocks "a" and "b"", and so on; of many the first few.
std::string block_names(const Solid& solid, const std::vector<int>& blocks);

}  // namespace blockweir::solid::output
