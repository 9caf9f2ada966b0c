// SPDX-License-Identifier: GPL-3.0-or-later
// Where a key belongs that stands at a wrong place, after the reference of keys.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blockweir::scene {

extern const char* const keys_page;  ///< bridge/scene/KEYS.md, embedded by the build

/// Full paths of a key as --set takes them: "water.may_overtop", "block.NAME.fixed".
std::vector<std::string> homes_of_key(std::string_view key);

/// What to write instead; empty where there is no such key, or where it belongs to more sections than help.
std::string home_advice(std::string_view key);

}  // namespace blockweir::scene
