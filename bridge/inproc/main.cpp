// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-inproc: the solid and the water that this program has in one process: still water, and water that responds.
// What they say to each other, and all results, are those of two.
#include "bridge/process/program.hpp"

using namespace blockweir;

namespace {

std::unique_ptr<schedule::FluidSide> water_of(const scene::Scene& scene, const std::filesystem::path& folder) {
  return scene.fluid == scene::FluidModel::reservoir ? reservoir::make(scene, folder)
                                                     : hydrostatic::make(scene, folder);
}

}  // namespace

int main(int argc, char** argv) {
  process::SolidProcess solid{.make_fluid = water_of};
  std::string report;
  const process::Program program{
      "blockweir-inproc",
      "the blocks of a scene and the water on them, still or a reservoir that responds, in one process",
      {process::solid_options(solid), {{"--report", &report, "file for the fluid's times and counts (JSON)"}}}};
  return process::run_program(argc, argv, program, [&] {
    const schedule::FluidReport said = process::run_process(solid);
    if (!report.empty()) schedule::write_report(report, said);
    return 0;
  });
}
