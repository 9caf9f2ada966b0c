// SPDX-License-Identifier: GPL-3.0-or-later
// The launcher's part of a fluid that is the user's own program: [fluid] model = "external". Protocol:
// bridge/wire/README.md.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/process/programs.hpp"

namespace blockweir::process {

/// Whether the scene has an external fluid without a command.
[[nodiscard]] bool is_started_by_hand(const scene::Scene& scene);

/// The folder in which an external fluid's command runs: the scene's, or that of the resumed run in `folder`. Empty for
/// other fluids. Throws std::runtime_error if the run's folder cannot be written.
[[nodiscard]] std::filesystem::path home_of_external(const scene::Scene& scene, const std::filesystem::path& folder);

/// Its environment has BLOCKWEIR_ENDPOINT, BLOCKWEIR_SCENE, BLOCKWEIR_FOLDER, BLOCKWEIR_REPORT, BLOCKWEIR_TIMEOUT_S.
[[nodiscard]] Command external_command(const scene::Scene& scene, const Processes& processes);

/// Instructions for a user who starts it by hand, several lines.
[[nodiscard]] std::string call_for_external(const scene::Scene& scene, const Processes& processes);

/// Whether the external fluid has memory but has written no checkpoint.
[[nodiscard]] bool lacks_checkpoint(const scene::Scene& scene, const std::filesystem::path& folder);

inline constexpr const char* no_checkpoint_of_external =
    "its external fluid has written no checkpoint, so that it cannot go on: run it anew, let the program write one "
    "when "
    "it is told to save (bridge/wire/README.md), or set remembers = false in [fluid.external] where its pressures "
    "depend on place "
    "and time alone";

}  // namespace blockweir::process
