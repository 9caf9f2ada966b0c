// SPDX-License-Identifier: GPL-3.0-or-later
// Values from the command line that replace those of the file: --set analysis.step_s=0.001.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// The place of an override for messages.
std::string override_place(const std::string& argument);

/// The key of "key = value", without blanks around it.
std::string setting_key(const std::string& setting);

/// Replaces names in a key by indices: "cut.lift.cohesion_pa" becomes "cut.0.cohesion_pa". Keys that set the same value
/// become equal.
std::string plain_key(const toml::table& file, const std::string& key);

/// Each override is "dotted.key=value"; the value is in TOML syntax or a bare word, with or
/// without blanks around the sign. Entries of a list of tables are
/// selected by index or by name (block.top.fixed=true).
void apply_overrides(toml::table& file, const std::vector<std::string>& overrides, Problems& problems);

}  // namespace blockweir::scene
