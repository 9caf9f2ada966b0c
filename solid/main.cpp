// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-solid: the DDA solid as a process of its own.
#include "bridge/scene/exit_status.hpp"
#include "bridge/schedule/process_options.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  schedule::SolidProcess process;
  CLI::App app{"blockweir-solid: blocks of a scene, moved by discontinuous deformation analysis"};
  schedule::add_solid_options(app, process);
  channel::add_line_options(app, process.line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return scene::exit_status("blockweir-solid", [&] {
    schedule::run_process(process);
    return 0;
  });
}
