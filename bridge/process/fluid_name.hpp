// SPDX-License-Identifier: GPL-3.0-or-later
// How messages call the fluid of a scene.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::process {

/// A user's fluid that has not said its name yet, by its command; one that is started by hand has none.
inline std::string external_fluid_name(const std::vector<std::string>& command) {
  return command.empty() ? "external fluid" : fmt::format("external fluid \"{}\"", fmt::join(command, " "));
}

inline std::string fluid_name(const scene::Scene& scene) {
  const scene::FluidEntry& fluid = scene::fluid_entry(scene.fluid);
  return fluid.yours ? external_fluid_name(scene.external.command) : fmt::format("fluid process ({})", fluid.name);
}

}  // namespace blockweir::process
