// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-openfoam: writes interFoam's case from a scene and runs it.
#include <CLI/CLI.hpp>

#include "bridge/channel/line_options.hpp"
#include "bridge/process/exit_status.hpp"
#include "bridge/scene/read/read.hpp"
#include "fluid/openfoam/programs.hpp"
#include "fluid/openfoam/run_case.hpp"

int main(int argc, char** argv) {
  using namespace blockweir;
  std::string scene_path;
  std::vector<std::string> overrides;
  openfoam::RunOptions options;
  const scene::FluidEntry& entry = scene::fluid_entry(scene::FluidModel::openfoam);
  CLI::App app{std::string(entry.program) + ": " + entry.about};
  app.add_option("scene", scene_path, "scene file or case folder")->required();
  channel::add_line_options(app, options.line);
  app.add_option("--out", options.folder, "folder for the case and its results")->required();
  app.add_option("--set", overrides, "set a key of the scene, as key=value; the same for both processes");
  app.add_option("--scene-folder", options.scene_folder, "where the scene's paths start, for a copy of its file");
  app.add_option("--report", options.report, "file for this process's times and the checks of the water (JSON)");
  app.add_option("--resume", options.resume,
                 "continue from the checkpoint of this number in --out; the same for both processes");
  app.set_version_flag("--version", openfoam::openfoam_version, "the OpenFOAM that is found");
  app.add_flag("--case-only", options.case_only, "write the case, and run nothing");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return process::exit_status(entry.program, [&] {
    const scene::Scene scene = scene::read(scene_path, overrides).scene;
    return openfoam::run_case(scene, options);
  });
}
