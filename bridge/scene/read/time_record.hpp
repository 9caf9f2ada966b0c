// SPDX-License-Identifier: GPL-3.0-or-later
// Time tables that a scene keeps in separate files, above all accelerograms.
#pragma once

#include <toml++/toml.h>
#include <filesystem>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Replaces each { file = "record.csv", ... } of the scene by a { table = ... } with the file's content, so that the
/// scene's text and digest include it. Paths are relative to `folder`. Returns true if there was one.
bool take_records(toml::table& file, const std::filesystem::path& folder, Problems& problems);

}  // namespace blockweir::scene
