// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-hydrostatic: the reference fluid as a process of its own.
#include "bridge/process/fluid_program.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  return process::run_fluid_program(argc, argv, scene::FluidModel::hydrostatic,
                                    "still water that presses on the blocks of a scene", process::make_hydrostatic);
}
