// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid that is a program of the user's, from the launcher's side: [fluid] model = "external". bridge/wire/README.md
// says what it is told.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/process/programs.hpp"

namespace blockweir::process {

/// Does the scene have an external fluid, and no command for it?
[[nodiscard]] bool is_started_by_hand(const scene::Scene& scene);

/// Where an external fluid's command runs: in the scene's folder, or that of the run that is resumed in `folder`. Empty
/// for other fluids. Throws std::runtime_error where the run's folder takes no file.
[[nodiscard]] std::filesystem::path home_of_external(const scene::Scene& scene, const std::filesystem::path& folder);

/// It gets BLOCKWEIR_ENDPOINT, BLOCKWEIR_SCENE, BLOCKWEIR_FOLDER, BLOCKWEIR_REPORT and BLOCKWEIR_TIMEOUT_S.
[[nodiscard]] Command external_command(const scene::Scene& scene, const Processes& processes);

/// What whoever starts it by hand has to know, several lines.
[[nodiscard]] std::string call_for_external(const scene::Scene& scene, const Processes& processes);

/// Is there an external fluid that remembers, and has not written what it remembers?
[[nodiscard]] bool lacks_checkpoint(const scene::Scene& scene, const std::filesystem::path& folder);

inline constexpr const char* no_checkpoint_of_external =
    "its external fluid has written no checkpoint, so that it cannot go on: run it anew, let the program write one "
    "when "
    "it is told to save (bridge/wire/README.md), or set remembers = false in [fluid.external] where its pressures "
    "depend on place "
    "and time alone";

}  // namespace blockweir::process
