// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-openfoam: writes interFoam's case from a scene and runs it.
#include "bridge/process/program.hpp"
#include "bridge/scene/read/read.hpp"
#include "fluid/openfoam/programs.hpp"
#include "fluid/openfoam/run_case.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  constexpr auto required = process::ProgramOption::Use::required;
  std::string scene_path;
  std::vector<std::string> overrides;
  openfoam::RunOptions options;
  const scene::FluidEntry& entry = scene::fluid_entry(scene::FluidModel::openfoam);
  const process::Program program{
      entry.program,
      entry.about,
      {{{"scene", &scene_path, "scene file or case folder", required}},
       process::connection_options(options.line),
       {{"--out", &options.folder, "folder for the case and its results", required},
        {"--set", &overrides, "set a key of the scene, as key=value; the same for both processes"},
        {"--scene-folder", &options.scene_folder, "where the scene's paths start, for a copy of its file"},
        {"--report", &options.report, "file for this process's times and the checks of the water (JSON)"},
        {"--resume", &options.resume,
         "continue from the checkpoint of this number in --out; the same for both processes"},
        {"--version", openfoam::openfoam_version, "the OpenFOAM that is found"},
        {"--case-only", &options.case_only, "write the case, and run nothing"}}}};
  return process::run_program(argc, argv, program, [&] {
    const scene::Scene scene = scene::read(scene_path, overrides).scene;
    return openfoam::run_case(scene, options);
  });
}
