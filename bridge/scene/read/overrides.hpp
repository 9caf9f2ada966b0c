// SPDX-License-Identifier: GPL-3.0-or-later
// Values that the command line sets over those of the file: --set analysis.step_s=0.001.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// The place of what an override states, as messages call it.
std::string override_place(const std::string& argument);

/// "cut.lift.cohesion_pa" as "cut.0.cohesion_pa" where that is the entry's index: two keys that set one value are
/// equal.
std::string plain_key(const toml::table& file, const std::string& key);

/// Each override is "dotted.key=value", the value in TOML's syntax or a bare word; entries of a list of tables
/// are named by their index or their name (block.top.fixed=true).
void apply_overrides(toml::table& file, const std::vector<std::string>& overrides, Problems& problems);

}  // namespace blockweir::scene
