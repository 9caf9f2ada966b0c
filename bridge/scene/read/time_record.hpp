// SPDX-License-Identifier: GPL-3.0-or-later
// Courses in time that a scene keeps in files of their own, accelerograms above all.
#pragma once

#include <toml++/toml.h>
#include <filesystem>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Replaces each { file = "record.csv", ... } of the scene by the { table = ... } that the file holds, so that the
/// scene's text and digest cover it. Paths are relative to `folder`. True when there was one.
bool take_records(toml::table& file, const std::filesystem::path& folder, Problems& problems);

}  // namespace blockweir::scene
