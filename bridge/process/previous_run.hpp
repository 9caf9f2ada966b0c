// SPDX-License-Identifier: GPL-3.0-or-later
// Recognizes the folder of a previous run, and clears it for the next one.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::process {

/// Whether a run has written to this folder.
[[nodiscard]] bool is_run(const std::filesystem::path& folder);

/// Whether a run has got far enough to have something to look at.
[[nodiscard]] bool has_frames(const std::filesystem::path& folder);

/// Whether the folder contains files that no run has written. Something that is no folder is refused by make_folder.
[[nodiscard]] bool is_anothers(const std::filesystem::path& folder);

/// Throws std::invalid_argument if `folder` holds results that a run of `scene` there would lose: those of another
/// scene, or of a run that can be resumed. The message tells keys that differ, and which of them `overrides` (--set)
/// state.
void refuse_to_lose(const std::filesystem::path& folder, const scene::Scene& scene,
                    const std::vector<std::string>& overrides);

/// Whether the solid of that run failed in a way that a resumed run would repeat.
[[nodiscard]] bool ends_there_again(const std::filesystem::path& folder);

/// Whether it has a checkpoint from which it would go on.
[[nodiscard]] bool can_be_resumed(const std::filesystem::path& folder);

/// Its summary.json; no object where there is none that can be read.
[[nodiscard]] nlohmann::json summary_of(const std::filesystem::path& folder);

/// "results of "blockweir safety"": what a folder holds that is no run but the answer to another question; empty if it
/// holds none.
[[nodiscard]] std::string answers_in(const std::filesystem::path& folder);

void forget_checkpoints(const std::filesystem::path& folder);

/// Removes the files of runs and of their figures, except those that the run of `scene` is sure to replace. Throws
/// std::filesystem::filesystem_error if something cannot be removed.
void forget_previous_run(const std::filesystem::path& folder, const scene::Scene& scene);

}  // namespace blockweir::process
