// SPDX-License-Identifier: GPL-3.0-or-later
// The main program of a fluid process, without the fluid itself.
#pragma once

#include "bridge/process/sides.hpp"

namespace blockweir::process {

/// main() of the fluid `model`, which `make` creates from the scene and the folder of --out (empty: not given). Returns
/// the exit status.
int run_fluid_program(int argc, char** argv, scene::FluidModel model, const FluidMaker& make);

}  // namespace blockweir::process
