// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-solid: the DDA solid as a process of its own.
#include "bridge/process/exit_status.hpp"
#include "bridge/process/solid_options.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  process::SolidProcess side;
  CLI::App app{"blockweir-solid: blocks of a scene, moved by discontinuous deformation analysis"};
  process::add_solid_options(app, side);
  channel::add_line_options(app, side.line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return process::exit_status("blockweir-solid", [&] {
    process::run_process(side);
    return 0;
  });
}
