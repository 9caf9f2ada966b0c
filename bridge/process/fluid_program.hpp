// SPDX-License-Identifier: GPL-3.0-or-later
// The main program of a fluid process, without the fluid itself.
#pragma once

#include "bridge/process/sides.hpp"

namespace blockweir::process {

/// Throws std::invalid_argument if the scene has another fluid.
void require_fluid(const scene::Scene& scene, scene::FluidModel model);

/// main() of the fluid `model`, which `make` creates from the scene and the folder of --out (empty: not given). Returns
/// the exit status.
int run_fluid_program(int argc, char** argv, scene::FluidModel model, const FluidMaker& make);

}  // namespace blockweir::process
