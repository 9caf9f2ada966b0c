// SPDX-License-Identifier: GPL-3.0-or-later
// The scene of a load case.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/load_case.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::study {

/// Reads and checks the scene with the load case's settings. Throws scene::SceneError that names the load case.
scene::ReadScene load_case_scene(const scene::LoadCase& load_case, const std::filesystem::path& scene,
                                 const std::vector<std::string>& overrides);

/// Warns of a load case that does not change the scene; none if it does.
std::optional<scene::Diagnostic> idle_load_case(const scene::LoadCase& load_case, scene::Scene without,
                                                scene::Scene with);

/// Warns of each "joint.KEY=..." of a load case that does not reach some joints because they state the key themselves.
/// `with`: the scene of the load case.
std::vector<scene::Diagnostic> missed_joints(const scene::LoadCase& load_case, const scene::Scene& with);

}  // namespace blockweir::study
