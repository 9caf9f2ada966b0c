// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/run_case.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/checkpoint/checkpoints.hpp"
#include "bridge/launch/supervisor.hpp"
#include "bridge/results/result_file.hpp"
#include "fluid/openfoam/case_writer.hpp"
#include "fluid/openfoam/water_checks.hpp"

namespace blockweir::openfoam {
namespace {

namespace fs = std::filesystem;
constexpr double grace_s = 3;

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string folders = path != nullptr ? path : "";
  for (std::size_t from = 0; from <= folders.size();) {
    const std::size_t to = std::min(folders.find(':', from), folders.size());
    if (fs::exists(fs::path(folders.substr(from, to - from)) / program)) return true;
    from = to + 1;
  }
  return false;
}

/// Debian's OpenFOAM has no environment to source: its programs need to be told where their settings are.
void find_openfoam() {
  if (!on_path("interFoam")) {
    throw std::runtime_error(
        "OpenFOAM's interFoam is not on the PATH; install Debian's package openfoam or source the environment of "
        "another, or use [fluid] model = \"hydrostatic\"");
  }
  if (std::getenv("WM_PROJECT_DIR") != nullptr) return;
  ::setenv("WM_PROJECT_DIR", "/usr/share/openfoam", 0);
  ::setenv("WM_PROJECT", "OpenFOAM", 0);
  ::setenv("WM_PROJECT_VERSION", "v1912", 0);
}

/// Beside this program in a build tree, in ../lib of an installation.
fs::path find_plugin() {
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : {here, here.parent_path() / "lib"}) {
    if (fs::exists(folder / "libblockweirOpenFOAM.so")) return folder / "libblockweirOpenFOAM.so";
  }
  throw std::runtime_error(fmt::format(
      "OpenFOAM's plugin libblockweirOpenFOAM.so is neither in {} nor in ../lib beside it: this blockweir was built "
      "without OpenFOAM's headers; fluid/README.md says how to get them",
      here.string()));
}

/// The message of OpenFOAM's last FATAL ERROR as one line, or what its end looks like without one.
std::string cause(const fs::path& log, int exit_code) {
  std::ifstream stream(log);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("FOAM FATAL") != std::string::npos) {
      inside = true;
      text.clear();
    } else if (inside && line.find("From ") != std::string::npos) {
      inside = false;
    } else if (inside && line.find_first_not_of(" \t\r") != std::string::npos) {
      text += (text.empty() ? "" : " ") + line.substr(line.find_first_not_of(" \t"));
    }
  }
  if (!text.empty()) return text;
  if (exit_code == 128 + 8 || exit_code == 128 + 6) {
    return "a floating point exception: the solution has diverged; smaller windows or a lower max_courant may help";
  }
  if (exit_code > 128) return fmt::format("ended by signal {}", exit_code - 128);
  return fmt::format("ended with status {}", exit_code);
}

void run_program(const std::string& name, std::vector<std::string> words, const fs::path& folder) {
  launch::Command command{name, std::move(words)};
  command.output = folder / ("log." + name);
  const launch::Supervised end = launch::supervise({command}, folder, grace_s, [] {});
  if (end.interrupted) throw std::runtime_error("asked to stop");
  if (!end.all_fine()) {
    throw std::runtime_error(fmt::format("{}: {} (see {})", name, cause(command.output, end.ends.front().exit_code),
                                         command.output.string()));
  }
}

/// That interFoam's fields were written at.
double time_of_checkpoint(const scene::Scene& scene, const fs::path& folder, std::uint64_t number) {
  double time_s = 0;
  checkpoint::unpack(checkpoint::Checkpoints(folder, "openfoam", scene.digest, 0).read(number), time_s);
  return time_s;
}

int run_solver(const scene::Scene& scene, const fs::path& folder, const RunOptions& options) {
  if (scene.openfoam.processes == 1) {
    run_program("interFoam", {"interFoam", "-case", folder}, folder);
  } else {
    run_program("interFoam",
                {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np", std::to_string(scene.openfoam.processes),
                 "interFoam", "-parallel", "-case", folder},
                folder);
  }
  const nlohmann::json result = {{"checks", water_checks(scene, folder / "water.csv")}};
  if (!options.result.empty()) results::replace_file(options.result, result.dump(2) + "\n");
  return 0;
}

}  // namespace

int run_case(const scene::Scene& scene, const RunOptions& options) {
  if (scene.fluid != scene::FluidModel::openfoam) {
    throw std::invalid_argument("the scene's fluid is not OpenFOAM: set model = \"openfoam\" in [fluid]");
  }
  if (!options.case_only) find_openfoam();
  const Grid grid = make_grid(scene);
  const fs::path folder = fs::absolute(options.folder);
  const CaseOptions written{folder, find_plugin(), options.endpoint};
  if (options.resume > 0) {
    prepare_resumption(scene, grid, written, options.resume, time_of_checkpoint(scene, folder, options.resume));
    return run_solver(scene, folder, options);
  }
  write_case(scene, grid, written);
  if (options.case_only) {
    fmt::print("{}: {} cells in {} columns and {} rows, {:.4g} m beside the structure\n", folder.string(), grid.cells(),
               grid.columns(), grid.rows(), grid.cell_m);
    return 0;
  }
  run_program("blockMesh", {"blockMesh", "-case", folder}, folder);
  if (scene.openfoam.processes > 1) run_program("decomposePar", {"decomposePar", "-force", "-case", folder}, folder);
  return run_solver(scene, folder, options);
}

}  // namespace blockweir::openfoam
