// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/run_case.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/process/require_fluid.hpp"
#include "bridge/results/peak_memory.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/saving.hpp"
#include "bridge/results/stopwatch.hpp"
#include "fluid/openfoam/case_writer.hpp"
#include "fluid/openfoam/own_case.hpp"
#include "fluid/openfoam/programs.hpp"
#include "fluid/openfoam/resolution.hpp"
#include "fluid/openfoam/water_checks.hpp"

namespace blockweir::openfoam {
namespace {

namespace fs = std::filesystem;

/// What no former call has marked as ours is somebody's own.
void refuse_anothers(const fs::path& folder) {
  std::error_code none;
  if (fs::directory_iterator(folder, none) == fs::directory_iterator()) return;
  if (fs::exists(folder / "constant/blockweir")) return;
  throw std::invalid_argument(fmt::format(
      "--out {}: not empty and not a case that blockweir has written; choose another folder", folder.string()));
}

/// Makes the case for interFoam and a file to open it in ParaView; returns a line on it. Adds warnings on a coarse
/// mesh.
std::string make_case(const scene::Scene& scene, const RunOptions& options, const CaseOptions& writing,
                      std::vector<std::string>& warnings) {
  const fs::path& folder = writing.folder;
  refuse_anothers(folder);
  if (scene.openfoam.own_case.empty()) {
    const Grid grid = make_grid(scene);
    warnings = check_resolution(scene, grid);
    write_case(scene, grid, writing);
    results::replace_file(folder / "water.foam", "");
    if (!options.case_only) run_program("blockMesh", {"blockMesh", "-case", folder}, folder);
    return fmt::format("{}: {} cells in {} columns and {} rows, {:.4g} m beside the structure\n", folder.string(),
                       grid.cells(), grid.columns(), grid.rows(), grid.cell_m);
  }
  const fs::path here = options.scene_folder.empty() ? scene.file.parent_path() : options.scene_folder;
  const fs::path own = (here / scene.openfoam.own_case).lexically_normal();
  adopt_case(scene, own, writing);
  results::replace_file(folder / "water.foam", "");
  return fmt::format("{}: a copy of {} with the blocks\n", folder.string(), own.string());
}

/// From a checkpoint, in the case that stands there: that interFoam's fields were written at its time.
void go_on(const scene::Scene& scene, const RunOptions& options, const CaseOptions& writing) {
  double time_s = 0;
  checkpoint::unpack(checkpoint::Checkpoints(writing.folder, "openfoam", scene.digest, 0).read(options.resume), time_s);
  const bool own = !scene.openfoam.own_case.empty();
  prepare_resumption(scene, own ? own_surroundings(scene) : surroundings(scene, make_grid(scene)), writing,
                     options.resume, time_s);
}

/// What the plugin is not to find in a case, which may be copied to anybody.
void tell_plugin(const channel::Options& line) {
  if (!line.keys.empty()) ::setenv("BLOCKWEIR_KEYS", fs::absolute(line.keys).c_str(), 1);
  if (line.insecure) ::setenv("BLOCKWEIR_INSECURE", "1", 1);
}

/// Under Slurm mpirun starts the ranks on the allocation's nodes; rank 0 connects to the solid on the first node.
void require_own_node() {
  const char* job = std::getenv("SLURM_JOB_ID");
  if (job == nullptr || std::getenv("SLURMD_NODENAME") != nullptr) return;
  throw std::runtime_error(
      fmt::format("found the allocation of job {} on a machine that is not one of its nodes; expected blockweir on the "
                  "first node, beside interFoam's rank 0; put the command into a script for sbatch",
                  job));
}

void run_interfoam(const scene::Scene& scene, const fs::path& folder, double& seconds) {
  const Stopwatch watch(seconds);
  if (scene.openfoam.processes == 1) {
    run_program("interFoam", {"interFoam", "-case", folder}, folder);
  } else {
    require_own_node();
    run_program("interFoam",
                {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np", std::to_string(scene.openfoam.processes),
                 "interFoam", "-parallel", "-case", folder},
                folder);
  }
}

/// Names and numbers that the plugin has left.
template <class Number>
std::map<std::string, Number> numbers(const fs::path& path) {
  std::map<std::string, Number> all;
  std::ifstream file(path);
  std::string name;
  for (Number number = 0; file >> name >> number;) all[name] = number;
  return all;
}

/// Seconds by phase; interFoam's start and end are what is left.
std::map<std::string, double> times(const fs::path& folder, double solved_s) {
  auto seconds = numbers<double>(folder / "blockweir.times");
  double other_s = 0;
  for (const auto& [phase, s] : seconds) other_s += s;
  seconds["start_up"] = solved_s - other_s;
  return seconds;
}

/// As text, with the mean time of the work done, times the number skipped.
nlohmann::json skips(const std::map<std::string, double>& seconds, const std::map<std::string, long>& counts) {
  nlohmann::json list = nlohmann::json::array();
  if (counts.empty()) return list;
  const long passed = counts.at("windows_at_rest");
  const long windows = counts.at("windows");
  if (passed > 0) {
    list.push_back(fmt::format("interFoam's steps in {} of {} windows: water and blocks were at rest{}", passed,
                               passed + windows, results::saved(seconds.at("step"), windows, passed)));
  }
  const long skipped = counts.at("skipped_cuts");
  const long cuts = counts.at("cuts");
  if (skipped > 0) {
    list.push_back(
        fmt::format("cutting moved blocks out of cells, {} of {} times: no corner was beyond move_tolerance{}", skipped,
                    skipped + cuts, results::saved(seconds.at("cut"), cuts, skipped)));
  }
  return list;
}

int run_solver(const scene::Scene& scene, const fs::path& folder, const RunOptions& options,
               std::vector<std::string> warnings) {
  tell_plugin(options.line);
  double solved_s = 0;
  run_interfoam(scene, folder, solved_s);
  if (scene.openfoam.reconstruct) run_program("reconstructPar", {"reconstructPar", "-case", folder}, folder);
  const auto seconds = times(folder, solved_s);
  const auto counts = numbers<long>(folder / "blockweir.counts");
  std::ifstream of_plugin(folder / "blockweir.warnings");
  for (std::string warning; std::getline(of_plugin, warning);) warnings.push_back(warning);
  const nlohmann::json report = {{"seconds", seconds},
                                 {"counts", counts},
                                 {"skips", skips(seconds, counts)},
                                 {"warnings", warnings},
                                 {"peak_memory_mb", results::peak_memory_mb()},
                                 {"checks", water_checks(scene, folder / "water.csv")}};
  if (!options.report.empty()) results::replace_file(options.report, report.dump(2) + "\n");
  return 0;
}

}  // namespace

int run_case(const scene::Scene& scene, const RunOptions& options) {
  process::require_fluid(scene, scene::FluidModel::openfoam);
  if (!options.case_only || !scene.openfoam.own_case.empty()) find_openfoam();
  require_water_columns(scene);
  const CaseOptions writing{fs::absolute(options.folder), find_plugin(), options.line.endpoint};
  if (options.resume > 0) {
    go_on(scene, options, writing);
    return run_solver(scene, writing.folder, options, {});
  }
  std::vector<std::string> warnings;
  const std::string made = make_case(scene, options, writing, warnings);
  if (options.case_only) {
    fmt::print("{}", made);
    for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
    return 0;
  }
  const fs::path& folder = writing.folder;
  if (scene.openfoam.processes > 1) run_program("decomposePar", {"decomposePar", "-force", "-case", folder}, folder);
  return run_solver(scene, folder, options, warnings);
}

}  // namespace blockweir::openfoam
