// SPDX-License-Identifier: GPL-3.0-or-later
// What to do about a line that is no TOML: the slips of those who write scenes by hand.
#pragma once

#include <string>

namespace blockweir::scene {

/// Never empty.
[[nodiscard]] std::string remedy_of_syntax(const std::string& line);

}  // namespace blockweir::scene
