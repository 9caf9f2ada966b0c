// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-solid: the DDA solid as a process of its own.
#include "bridge/process/program.hpp"

int main(int argc, char** argv) {
  using namespace blockweir::process;
  SolidProcess solid;
  const Program program{"blockweir-solid",
                        "blocks of a scene, moved by discontinuous deformation analysis",
                        {solid_options(solid), connection_options(solid.line)}};
  return run_program(argc, argv, program, [&] {
    run_process(solid);
    return 0;
  });
}
