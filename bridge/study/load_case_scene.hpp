// SPDX-License-Identifier: GPL-3.0-or-later
// A load case as the scene that it makes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/load_case.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::study {

/// The scene as a load case sets it, checked. Throws scene::SceneError that names the load case.
scene::ReadScene load_case_scene(const scene::LoadCase& load_case, const std::filesystem::path& scene,
                                 const std::vector<std::string>& overrides);

/// Warns of a load case whose scene is the one without it; none where it is another.
std::optional<scene::Diagnostic> idle_load_case(const scene::LoadCase& load_case, scene::Scene without,
                                                scene::Scene with);

/// Warns of each "joint.KEY=..." of a load case that leaves joints as they are which state the key themselves. `with`
/// is the scene that it makes.
std::vector<scene::Diagnostic> missed_joints(const scene::LoadCase& load_case, const scene::Scene& with);

}  // namespace blockweir::study
