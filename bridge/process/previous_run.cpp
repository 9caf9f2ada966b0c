// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/previous_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/shell_word.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/read/differences.hpp"
#include "bridge/scene/read/digest.hpp"

namespace blockweir::process {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Of the scene that a run in this folder had.
std::string scene_text_of(const fs::path& folder) {
  std::ifstream stream(scene_of(folder), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Nothing is lost of a run that was refused at its start.
bool has_results(const fs::path& folder) {
  return has_frames(folder) || summary_of(folder).value("outcome", "stopped") != "stopped";
}

}  // namespace

bool is_run(const fs::path& folder) {
  std::error_code unreadable;
  return fs::exists(scene_of(folder), unreadable) && fs::exists(folder / "solid.log", unreadable);
}

bool has_frames(const fs::path& folder) {
  std::error_code unreadable;
  return fs::exists(folder / "blocks.pvd", unreadable);
}

bool is_anothers(const fs::path& folder) {
  std::error_code unreadable;
  const fs::directory_iterator contents(folder, unreadable);
  const auto counts = [](const fs::directory_entry& entry) {
    return entry.path().filename() != results::FolderLock::file;  // of a run that was killed as it began
  };
  return std::any_of(begin(contents), end(contents), counts) && !is_run(folder);
}

json summary_of(const fs::path& folder) {
  std::ifstream stream(folder / "summary.json");
  json summary = stream ? json::parse(stream, nullptr, /*allow_exceptions=*/false) : json();
  return summary.is_object() ? summary : json::object();
}

bool ends_there_again(const fs::path& folder) {
  return summary_of(folder).value("ends_here_again", false);
}

bool can_be_resumed(const fs::path& folder) {
  return !checkpoint::windows(folder, "solid").empty() && !ends_there_again(folder);
}

std::string answers_in(const fs::path& folder) {
  std::error_code unreadable;
  for (const char* question : {"safety", "level", "modes", "reliability"}) {
    if (is_run(folder) || !fs::exists(folder / fmt::format("{}.json", question), unreadable)) continue;
    return fmt::format("results of \"blockweir {}\"", question);
  }
  return {};
}

void refuse_to_lose(const fs::path& folder, const scene::Scene& scene, const std::vector<std::string>& overrides) {
  if (!is_run(folder)) return;
  const std::string before = scene_text_of(folder);
  const bool resumable = can_be_resumed(folder);
  const bool of_another = scene::digest(before) != scene.digest;
  if (!resumable && !(of_another && has_results(folder))) return;
  const std::string word = results::shell_word(folder.string());
  throw std::invalid_argument(fmt::format(
      "{}: found a run of {}{}; expected a new folder, or that of a complete run of this scene; choose another folder, "
      "or remove that run (rm -r {})",
      folder.string(),
      of_another ? "another scene: " + scene::differences_text(before, scene.text, overrides) : "this scene",
      resumable ? fmt::format(", which was stopped and goes on with \"blockweir resume {}\"", word) : "", word));
}

void forget_checkpoints(const fs::path& folder) {
  for (const scene::FluidEntry& fluid : scene::fluid_models) checkpoint::forget(folder / fluid.folder);
}

void forget_previous_run(const fs::path& folder, const scene::Scene& scene) {
  // Not the scene nor solid.log, by which the folder is known, even if this run is stopped right here.
  for (const char* file : {"summary.json", "history.csv", "frames.jsonl", "repeat.toml", "blocks.pvd", "reservoir.pvd",
                           "animation.gif", "report.html"}) {
    fs::remove(folder / file);
  }
  for (const scene::FluidEntry& fluid : scene::fluid_models) {
    if (fluid.program != nullptr || fluid.yours) fs::remove(folder / (fluid.role + std::string(".log")));
  }
  for (const char* picture :
       {"displacements", "velocities", "rotations", "level", "snapshots", "picture", "profile", "section"}) {
    for (const char* ending : {".png", ".svg"}) fs::remove(folder / (std::string(picture) + ending));
  }
  fs::remove(report_of(folder));
  fs::remove_all(trace_of(folder));
  fs::remove(folder / "trace.json");
  fs::remove_all(folder / "frames");
  forget_checkpoints(folder);
  fs::remove_all(folder / scene::fluid_entry(scene::FluidModel::external).folder);
  // A case of one's own is looked at before its copy is replaced: it may be this very folder.
  if (scene.openfoam.own_case.empty()) fs::remove_all(folder / "openfoam");
}

}  // namespace blockweir::process
