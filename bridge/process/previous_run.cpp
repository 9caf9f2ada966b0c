// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/previous_run.hpp"

#include <algorithm>

#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/scene/fluid_models.hpp"

namespace blockweir::process {

namespace fs = std::filesystem;

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
