// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-column: a pipe of water as a process of its own. Whoever writes a new fluid begins with a copy of this.
#include "bridge/process/fluid_program.hpp"
#include "fluid/column/column.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  return process::run_fluid_program(
      argc, argv, scene::FluidModel::column, "a pipe of water at the edge of a block",
      [](const scene::Scene& scene, const std::filesystem::path&) { return std::make_unique<column::Column>(scene); });
}
