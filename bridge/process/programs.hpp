// SPDX-License-Identifier: GPL-3.0-or-later
// The programs of a run, and the files that they share with the launcher.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/process/supervisor.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::process {

struct Processes {
  std::filesystem::path folder;          ///< of the run
  std::string endpoint;                  ///< where they connect
  std::uint64_t first = 0;               ///< checkpoint to resume from; 0: from the start
  bool inproc = false;                   ///< still water or a reservoir within the solid's process
  std::filesystem::path scene_folder{};  ///< where an external fluid's command runs
};

/// One of our programs, in the same folder as this one.
[[nodiscard]] std::filesystem::path program_beside(const std::string& name);

/// The name for results of a scene: its folder, or its file if that is not scene.toml.
[[nodiscard]] std::string case_name(const std::filesystem::path& scene);

/// The run's own copy of its scene.
[[nodiscard]] std::filesystem::path scene_of(const std::filesystem::path& folder);
/// File of a fluid's report for the summary.
[[nodiscard]] std::filesystem::path report_of(const std::filesystem::path& folder);

/// Folder in which the sides of a traced run record their activities.
[[nodiscard]] std::filesystem::path trace_of(const std::filesystem::path& folder);

/// Throws std::invalid_argument if `inproc` is set for a fluid that needs its own process.
void require_fit(const scene::Scene& scene, bool inproc);

/// The command that answers `question` on the scene in `folder` and writes the file `answer` (JSON).
[[nodiscard]] Command limit_command(const std::filesystem::path& folder, const std::string& question,
                                    const std::filesystem::path& answer);

/// The solid's command first. An external fluid that is started by hand has none.
[[nodiscard]] std::vector<Command> commands_of(const scene::Scene& scene, const Processes& processes);

}  // namespace blockweir::process
