// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene file holds beside the scene that is run: variants, load cases, studies, random numbers.
#pragma once

#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::launch {

struct SceneParts {
  std::vector<scene::Diagnostic> warnings;  ///< those that the scene itself does not have
  std::size_t studies = 0;
  scene::CollectedErrors wrong;
};

/// Checks each part, with `overrides`; `read`: the scene of `path` with them.
SceneParts check_parts(const scene::ReadScene& read, const std::filesystem::path& path,
                       const std::vector<std::string>& overrides);

/// Throws scene::SceneError with the problems of all parts as the file states them. A scene that only its overrides
/// make sound is left to these.
void require_sound_parts(const std::filesystem::path& path);

}  // namespace blockweir::launch
