// SPDX-License-Identifier: GPL-3.0-or-later
// Time tables that a scene keeps in separate files, above all accelerograms.
#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Where the rows of a record come from.
struct RecordSource {
  std::string file;               ///< as the scene states it
  std::vector<int> lines;         ///< of each row, the first line being 1
  std::optional<double> scale{};  ///< where the scene states one
};

/// By the table that describes them in the scene.
using RecordSources = std::map<const toml::node*, RecordSource>;

/// Replaces each { file = "record.csv", ... } of the scene by a { table = ... } with the file's content, so that the
/// scene's text and digest include it. Paths are relative to `folder`.
RecordSources take_records(toml::table& file, const std::filesystem::path& folder, Problems& problems);

}  // namespace blockweir::scene
