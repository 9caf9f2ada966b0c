// SPDX-License-Identifier: GPL-3.0-or-later
// The section at the moment that pictures show: failure, or the end of the run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

/// section_state at the frame chosen by `frames_data`; with fails_later_s where that is not yet the failure's moment.
/// For water other than still water, the pressures are those of the frame, not split into kinds. Throws
/// process::Stopped.
[[nodiscard]] nlohmann::json pictured_state(const scene::Scene& scene, const std::filesystem::path& run,
                                            const nlohmann::json& frames_data);

}  // namespace blockweir::picture
