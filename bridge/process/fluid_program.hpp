// SPDX-License-Identifier: GPL-3.0-or-later
// A fluid that answers over the line as a program of its own: all of it but the fluid.
#pragma once

#include "bridge/process/sides.hpp"

namespace blockweir::process {

/// Throws std::invalid_argument where the scene has another fluid.
void require_fluid(const scene::Scene& scene, scene::FluidModel model);

/// main() of the fluid `model`, which `make` makes from the scene and the folder of --out (empty: none was given).
/// Returns the exit status.
int run_fluid_program(int argc, char** argv, scene::FluidModel model, const FluidMaker& make);

}  // namespace blockweir::process
