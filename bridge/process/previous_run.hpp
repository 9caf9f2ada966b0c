// SPDX-License-Identifier: GPL-3.0-or-later
// A folder that a run has written: whether it is one, and how the next run gets it as if it were new.
#pragma once

#include <filesystem>

#include "bridge/scene/scene.hpp"

namespace blockweir::process {

/// Whether a run has written there.
[[nodiscard]] bool is_run(const std::filesystem::path& folder);

/// Whether a run has come so far there that there is something to look at.
[[nodiscard]] bool has_frames(const std::filesystem::path& folder);

/// Does the folder hold what no run has written? What is no folder at all is make_folder's to refuse.
[[nodiscard]] bool is_anothers(const std::filesystem::path& folder);

void forget_checkpoints(const std::filesystem::path& folder);

/// Removes what runs and the drawing of their figures have written, but for what `scene`'s run is sure to replace.
/// Throws std::filesystem::filesystem_error where something cannot be removed.
void forget_previous_run(const std::filesystem::path& folder, const scene::Scene& scene);

}  // namespace blockweir::process
