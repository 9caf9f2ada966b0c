// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a scene's fluid in messages.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::process {

/// Before a user's fluid has sent its name, its command serves as name; one that is started by hand has none.
inline std::string external_fluid_name(const std::vector<std::string>& command) {
  return command.empty() ? "external fluid" : fmt::format("external fluid \"{}\"", fmt::join(command, " "));
}

inline std::string fluid_name(const scene::Scene& scene) {
  const scene::FluidEntry& fluid = scene::fluid_entry(scene.fluid);
  return fluid.yours ? external_fluid_name(scene.external.command) : fmt::format("fluid process ({})", fluid.name);
}

}  // namespace blockweir::process
