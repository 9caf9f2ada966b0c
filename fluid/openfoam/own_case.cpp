// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/own_case.hpp"

#include <algorithm>
#include <stdexcept>

#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "fluid/openfoam/dictionary.hpp"
#include "fluid/openfoam/interface_dictionary.hpp"
#include "fluid/openfoam/programs.hpp"

namespace blockweir::openfoam {
namespace {

namespace fs = std::filesystem;
constexpr double beyond_any_mesh = 1e3;  // sizes of the model

[[noreturn]] void refuse(const fs::path& from, const std::string& found, const std::string& remedy) {
  throw std::invalid_argument(fmt::format("[fluid] case {}: {}; {}", from.string(), found, remedy));
}

/// A field may be compressed.
bool has_field(const fs::path& folder, const char* time, const std::string& name) {
  return fs::exists(folder / time / name) || fs::exists(folder / time / (name + ".gz"));
}

/// Before anything is copied.
void check_is_case(const fs::path& from) {
  if (!fs::is_directory(from)) refuse(from, "there is no such folder", "name an OpenFOAM case, relative to the scene");
  if (!fs::exists(from / "system/controlDict")) {
    refuse(from, "it has no system/controlDict", "expected an interFoam case with system, constant and 0 or 0.orig");
  }
  if (!fs::exists(from / "constant/polyMesh/points") && !fs::exists(from / "constant/polyMesh/points.gz") &&
      !fs::exists(from / "system/blockMeshDict")) {
    refuse(from, "it has neither constant/polyMesh nor system/blockMeshDict", "make its mesh first");
  }
  const char* start = fs::exists(from / "0") ? "0" : "0.orig";
  for (const char* field : {"alpha.water", "p_rgh", "U"}) {
    const bool in_orig = fs::exists(from / "0") && has_field(from, "0.orig", field);
    if (has_field(from, start, field)) continue;
    refuse(from, fmt::format("it has no {}/{}", start, field),
           in_orig ? "copy it from 0.orig, or take 0 away" : "interFoam's phases must be water and air");
  }
}

bool is_within(const fs::path& inner, const fs::path& outer) {
  const auto [end, unused] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return end == outer.end();
}

/// Results of former runs, and what they said.
bool is_left_over(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (name.rfind("log.", 0) == 0) return true;
  if (!entry.is_directory()) return false;
  const bool time = name != "0" && name.find_first_not_of("0123456789.e-+") == std::string::npos;
  return time || name.rfind("processor", 0) == 0 || name == "postProcessing";
}

void copy_case(const fs::path& from, const fs::path& to) {
  const fs::path source = fs::canonical(from);
  const fs::path target = fs::weakly_canonical(to);
  if (is_within(target, source) || is_within(source, target)) {
    refuse(from, fmt::format("it and the folder for its copy, {}, lie within each other", to.string()),
           "choose another folder for the results");
  }
  if (fs::exists(to / "constant/blockweir")) fs::remove_all(to);  // of a former run
  results::make_folder(to);
  for (const auto& entry : fs::directory_iterator(source)) {
    if (is_left_over(entry)) continue;
    fs::copy(entry.path(), to / entry.path().filename(),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
}

void set_control(const scene::Scene& scene, const CaseOptions& options) {
  const auto set = [&](const char* name, const std::string& value) {
    set_entry(options.folder, "system/controlDict", name, value);
  };
  set("startFrom", "latestTime");  // a run that is resumed has later ones
  set("startTime", "0");
  set("stopAt", "endTime");
  set("endTime", exact(end_time_s(scene)));
  set("deltaT", exact(first_step_s(scene)));
  set("adjustTimeStep", "no");
  set("runTimeModifiable", "no");
  set("timePrecision", "10");
  if (!entry(options.folder, "system/controlDict", "functions")) set("functions", "{}");
  const std::string library = fmt::format("libs ({});", quoted(options.plugin.string()));
  set("functions.blockweir", fmt::format("{{ type blockweirSchedule; {} }}", library));
  // OpenFOAM reads the one in constant where both are there.
  const char* sources = fs::exists(options.folder / "constant/fvOptions") ? "constant/fvOptions" : "system/fvOptions";
  if (!fs::exists(options.folder / sources)) {
    results::replace_file(options.folder / sources, file_header("dictionary", "fvOptions"));
  }
  set_entry(options.folder, sources, "blockweir", fmt::format("{{ type blockweirBlocks; active true; {} }}", library));
}

/// As in the scripts of OpenFOAM's tutorials. An existing folder 0 is used unchanged.
void make_what_lacks(const fs::path& folder) {
  const auto run = [&](const char* program) { run_program(program, {program, "-case", folder}, folder); };
  if (!fs::exists(folder / "constant/polyMesh/points") && !fs::exists(folder / "constant/polyMesh/points.gz")) {
    run("blockMesh");
  }
  if (fs::exists(folder / "0")) return;
  fs::copy(folder / "0.orig", folder / "0", fs::copy_options::recursive);
  if (fs::exists(folder / "system/setAlphaFieldDict")) {
    run("setAlphaField");
  } else if (fs::exists(folder / "system/setFieldsDict")) {
    run("setFields");
  }
}

}  // namespace

Surroundings own_surroundings(const scene::Scene& scene) {
  Surroundings around{find_site(scene), {}};
  around.depth_m = around.site.highest_m - around.site.model.low.y();
  const geometry::Bounds& model = around.site.model;
  const double beyond = beyond_any_mesh * model.size();
  around.outlines = outlines_up_to(model.low.x() - beyond, model.high.x() + beyond, around.site, scene);
  return around;
}

void adopt_case(const scene::Scene& scene, const fs::path& from, const CaseOptions& options) {
  check_is_case(from);
  copy_case(from, options.folder);
  // This marks the copy as ours.
  write_interface(options.folder, scene, own_surroundings(scene), options.endpoint, 0);
  const std::string application = entry(options.folder, "system/controlDict", "application").value_or("none");
  if (application != "interFoam") {
    refuse(from, fmt::format("its system/controlDict has application {}", application),
           "interFoam is the one that takes blocks");
  }
  set_control(scene, options);
  if (scene.openfoam.processes > 1) {
    results::replace_file(options.folder / "system/decomposeParDict", decompose_dictionary(scene));
  }
  make_what_lacks(options.folder);
}

}  // namespace blockweir::openfoam
