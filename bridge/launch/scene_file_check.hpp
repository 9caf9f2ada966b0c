// SPDX-License-Identifier: GPL-3.0-or-later
// Checks what a scene file holds beside the scene that is run: variants, load cases, studies, random variables.
#pragma once

#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::launch {

struct SceneFileCheck {
  std::vector<scene::Diagnostic> warnings;  ///< those that the scene itself does not have
  std::size_t studies = 0;
  scene::CollectedErrors wrong;
};

/// Checks each of them, with `overrides`; `read`: the scene of `path` with these.
SceneFileCheck check_scene_file(const scene::ReadScene& read, const std::filesystem::path& path,
                                const std::vector<std::string>& overrides);

/// Throws scene::SceneError with all problems of them, as the file states them, unless the overrides remove all. A
/// scene that only its overrides make sound is left to these. Benches are left to `check` and `bench`: where they are
/// many they took longer than all else before a run.
void require_sound_file(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

}  // namespace blockweir::launch
