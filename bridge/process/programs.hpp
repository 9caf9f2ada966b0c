// SPDX-License-Identifier: GPL-3.0-or-later
// The programs of a run, and the files through which they and the launcher know each other.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/process/supervisor.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::process {

struct Processes {
  std::filesystem::path folder;          ///< of the run
  std::string endpoint;                  ///< where they meet
  std::uint64_t first = 0;               ///< checkpoint to go on from; 0: from the start
  bool inproc = false;                   ///< still water or a reservoir within the solid's process
  std::filesystem::path scene_folder{};  ///< where an external fluid's command runs
};

/// One of our programs: it stands beside this one, wherever it was installed.
[[nodiscard]] std::filesystem::path program_beside(const std::string& name);

/// What results of a scene are called by: its folder, or its file where that is not scene.toml.
[[nodiscard]] std::string case_name(const std::filesystem::path& scene);

/// The run's own copy of its scene.
[[nodiscard]] std::filesystem::path scene_of(const std::filesystem::path& folder);
/// Where a fluid says what the summary needs.
[[nodiscard]] std::filesystem::path report_of(const std::filesystem::path& folder);

/// Folder in which the sides of a traced run say what they did when.
[[nodiscard]] std::filesystem::path trace_of(const std::filesystem::path& folder);

/// Throws std::invalid_argument where `inproc` is asked for a fluid that needs a process of its own.
void require_fit(const scene::Scene& scene, bool inproc);

/// Answers `question` about the scene in `folder` into the file `answer` (JSON).
[[nodiscard]] Command limit_command(const std::filesystem::path& folder, const std::string& question,
                                    const std::filesystem::path& answer);

/// The solid's first. One of an external fluid that is started by hand is not among them.
[[nodiscard]] std::vector<Command> commands_of(const scene::Scene& scene, const Processes& processes);

}  // namespace blockweir::process
