// SPDX-License-Identifier: GPL-3.0-or-later
// The section at the moment of a run that pictures show: its failure, or its end.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// section_state at the frame that `frames_data` has chosen. Where the run's water is no still water its pressures are
/// the frame's, of one kind. Throws process::Stopped.
[[nodiscard]] nlohmann::json pictured_state(const scene::Scene& scene, const std::filesystem::path& run,
                                            const nlohmann::json& frames_data);

}  // namespace blockweir::picture
