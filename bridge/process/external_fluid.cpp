// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/external_fluid.hpp"

#include <fmt/format.h>

#include <fstream>

#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/shell_word.hpp"
#include "bridge/scene/fluid_models.hpp"

namespace blockweir::process {
namespace {

namespace fs = std::filesystem;

constexpr const scene::FluidEntry& external = scene::fluid_entry(scene::FluidModel::external);

/// NAME=value each.
std::vector<std::string> environment_of(const scene::Scene& scene, const Processes& processes) {
  return {"BLOCKWEIR_ENDPOINT=" + processes.endpoint,
          "BLOCKWEIR_SCENE=" + fs::absolute(scene_of(processes.folder)).string(),
          "BLOCKWEIR_FOLDER=" + fs::absolute(processes.folder / external.folder).string(),
          "BLOCKWEIR_REPORT=" + fs::absolute(report_of(processes.folder)).string(),
          fmt::format("BLOCKWEIR_TIMEOUT_S={}", scene.coupling.timeout_s)};
}

/// Empty where there is no such note.
fs::path noted_home(const fs::path& note) {
  std::ifstream stream(note);
  std::string home;
  std::getline(stream, home);
  return home;
}

}  // namespace

bool is_started_by_hand(const scene::Scene& scene) {
  return scene.fluid == external.model && scene.external.command.empty();
}

fs::path home_of_external(const scene::Scene& scene, const fs::path& folder) {
  if (scene.fluid != external.model) return {};
  const fs::path own = folder / external.folder;
  const fs::path note = own / "started_in";
  const fs::path beside = fs::absolute(scene.file).parent_path();
  fs::path home = noted_home(note);
  if (!home.empty()) return home;
  home = noted_home(beside / external.folder / "started_in");  // the scene is the copy that a run has kept
  if (home.empty()) home = beside;
  results::make_folder(own);
  results::replace_file(note, home.string() + "\n");
  return home;
}

Command external_command(const scene::Scene& scene, const Processes& processes) {
  return {.name = external.role,
          .words = scene.external.command,
          .output = processes.folder / (std::string(external.role) + ".log"),
          .folder = processes.scene_folder,
          .environment = environment_of(scene, processes),
          .remedy = fmt::format("correct command in [fluid.external]; its paths start in {}",
                                processes.scene_folder.string()),
          .external = true};
}

std::string call_for_external(const scene::Scene& scene, const Processes& processes) {
  std::string text = fmt::format(
      "[fluid.external] has no command: waiting up to {:.4g} s for an external fluid; start it in another shell, "
      "after\n",
      scene.coupling.open_timeout_s);
  for (const std::string& setting : environment_of(scene, processes)) {
    const std::size_t value = setting.find('=') + 1;
    text += fmt::format("  export {}{}\n", setting.substr(0, value), results::shell_word(setting.substr(value)));
  }
  return text;
}

bool lacks_checkpoint(const scene::Scene& scene, const fs::path& folder) {
  return scene.fluid == external.model && scene.external.remembers && !checkpoint::windows(folder, "solid").empty() &&
         checkpoint::windows(folder / external.folder, external.role).empty();
}

}  // namespace blockweir::process
