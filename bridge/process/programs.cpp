// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/programs.hpp"

#include <fmt/format.h>

#include "bridge/process/external_fluid.hpp"
#include "bridge/scene/fluid_models.hpp"

namespace blockweir::process {
namespace {

namespace fs = std::filesystem;
using scene::FluidModel;

}  // namespace

fs::path program_beside(const std::string& name) {
  return fs::read_symlink("/proc/self/exe").parent_path() / name;
}

std::string case_name(const fs::path& scene) {
  const fs::path given = fs::weakly_canonical(scene);
  if (fs::is_directory(given)) return given.filename();
  return given.filename() == "scene.toml" ? given.parent_path().filename() : given.stem();
}

fs::path scene_of(const fs::path& folder) {
  return folder / "scene.toml";
}

fs::path report_of(const fs::path& folder) {
  return folder / "fluid.json";
}

fs::path trace_of(const fs::path& folder) {
  return folder / "trace";
}

void require_fit(const scene::Scene& scene, bool inproc) {
  if (!inproc || scene.fluid == FluidModel::none || scene::still_pools(scene.fluid)) return;
  throw std::invalid_argument(fmt::format(
      "--inproc: found model = \"{}\" in [fluid]; only \"hydrostatic\" and \"reservoir\" run in the solid's "
      "process, leave --inproc away",
      scene::name(scene.fluid)));
}

Command limit_command(const fs::path& folder, const std::string& question, const fs::path& answer) {
  return {"limit", {program_beside("blockweir-limit"), question, scene_of(folder), "--answer", answer}};
}

std::vector<Command> commands_of(const scene::Scene& scene, const Processes& processes) {
  const scene::FluidEntry& fluid = scene::fluid_entry(scene.fluid);
  const fs::path report = report_of(processes.folder);
  std::vector<Command> commands;
  const auto add = [&](const char* name, const char* file, const std::vector<std::string>& more) {
    Command& command = commands.emplace_back(Command{name, {program_beside(file), scene_of(processes.folder)}});
    command.words.insert(command.words.end(), more.begin(), more.end());
    if (processes.first > 0) command.words.insert(command.words.end(), {"--resume", std::to_string(processes.first)});
  };
  if (processes.inproc && fluid.program != nullptr) {
    add("solid", "blockweir-inproc", {"--out", processes.folder, "--report", report});
    return commands;
  }
  add("solid", "blockweir-solid", {"--out", processes.folder});
  if (fluid.program == nullptr && !fluid.yours) return commands;
  commands.back().words.insert(commands.back().words.end(), {"--endpoint", processes.endpoint});
  if (fluid.yours) {
    if (!scene.external.command.empty()) commands.push_back(external_command(scene, processes));
    return commands;
  }
  add(fluid.role, fluid.program,
      {"--endpoint", processes.endpoint, "--out", processes.folder / fluid.folder, "--report", report});
  if (fluid.reads_files) {
    commands.back().words.insert(commands.back().words.end(),
                                 {"--scene-folder", fs::absolute(scene.file).parent_path()});
  }
  return commands;
}

}  // namespace blockweir::process
