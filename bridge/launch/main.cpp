// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir: the command line.
#include "bridge/launch/command_line.hpp"
#include "bridge/process/exit_status.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  return process::exit_status("blockweir", [&] { return launch::run_command_line(argc, argv); });
}
