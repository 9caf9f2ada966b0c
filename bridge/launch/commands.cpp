// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/commands.hpp"

#include <fmt/format.h>

#include "bridge/scene/names.hpp"

namespace blockweir::launch {
namespace {

namespace fs = std::filesystem;
using scene::FluidModel;

/// Programs stand beside this one, wherever it was installed.
fs::path program(const char* name) {
  return fs::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace

fs::path scene_of(const fs::path& folder) {
  return folder / "scene.toml";
}

fs::path report_of(const fs::path& folder) {
  return folder / "fluid.json";
}

void require_fit(const scene::Scene& scene, bool inproc) {
  if (!inproc || scene.fluid == FluidModel::hydrostatic || scene.fluid == FluidModel::none) return;
  throw std::invalid_argument(
      fmt::format("--inproc: found model = \"{}\" in [fluid]; only \"hydrostatic\" runs in the solid's process, leave "
                  "--inproc away",
                  scene::name(scene.fluid)));
}

std::vector<Command> commands_of(const scene::Scene& scene, const Processes& processes) {
  const fs::path report = report_of(processes.folder);
  std::vector<Command> commands;
  const auto add = [&](const char* name, const char* file, const std::vector<std::string>& more) {
    Command& command = commands.emplace_back(Command{name, {program(file), scene_of(processes.folder)}});
    command.words.insert(command.words.end(), more.begin(), more.end());
    if (processes.first > 0) command.words.insert(command.words.end(), {"--resume", std::to_string(processes.first)});
  };
  const auto add_fluid = [&](const char* name, const char* file, const fs::path& out) {
    add(name, file, {"--endpoint", processes.endpoint, "--out", out, "--report", report});
  };
  if (processes.inproc && scene.fluid == FluidModel::hydrostatic) {
    add("solid", "blockweir-inproc", {"--out", processes.folder, "--report", report});
    return commands;
  }
  add("solid", "blockweir-solid", {"--out", processes.folder});
  if (scene.fluid == FluidModel::none) return commands;
  commands.back().words.insert(commands.back().words.end(), {"--endpoint", processes.endpoint});
  switch (scene.fluid) {
    case FluidModel::hydrostatic:
      add_fluid("hydrostatic", "blockweir-hydrostatic", processes.folder);
      break;
    case FluidModel::column:
      add_fluid("column", "blockweir-column", processes.folder);
      break;
    case FluidModel::openfoam:
      add_fluid("openfoam", "blockweir-openfoam", processes.folder / "openfoam");
      commands.back().words.insert(commands.back().words.end(),
                                   {"--scene-folder", fs::absolute(scene.file).parent_path()});
      break;
    case FluidModel::none:
      break;
  }
  return commands;
}

}  // namespace blockweir::launch
