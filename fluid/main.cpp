// SPDX-License-Identifier: GPL-3.0-or-later
// The program of a fluid: blockweir_fluid(NAME) in CMake compiles this file for each, with BLOCKWEIR_FLUID = NAME.
#include "bridge/process/fluid_program.hpp"

namespace blockweir::BLOCKWEIR_FLUID {

/// The fluid's folder, fluid/NAME, defines it.
std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder);

}  // namespace blockweir::BLOCKWEIR_FLUID

int main(int argc, char** argv) {
  using namespace blockweir;
  return process::run_fluid_program(argc, argv, scene::FluidModel::BLOCKWEIR_FLUID, BLOCKWEIR_FLUID::make);
}
