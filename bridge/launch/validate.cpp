// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/validate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/launch/cases_folder.hpp"
#include "bridge/launch/run.hpp"
#include "bridge/launch/temporary_folder.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read.hpp"

namespace blockweir::launch {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<fs::path> all_cases() {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::directory_iterator(cases_folder())) {
    if (fs::exists(entry.path() / "scene.toml")) cases.push_back(entry.path());
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

/// One run of a case: as it is, or one of its variants, with a point of the sweep.
struct Trial {
  std::string label;  ///< for the table
  RunOptions run;
};

std::vector<Trial> trials(const fs::path& path, const ValidateOptions& options) {
  std::vector<Trial> all;
  std::vector<std::string> variants{""};
  for (const auto& variant : scene::read(path).scene.variants) variants.push_back(variant.name);
  for (const std::string& variant : variants) {
    Trial trial{path.filename().string() + (variant.empty() ? "" : ", " + variant),
                {.scene = path, .variant = variant, .overrides = options.overrides, .quiet = true}};
    if (!options.sweep) {
      all.push_back(trial);
      continue;
    }
    for (const char* penalty : {"5e6", "1e9", "1e12"}) {
      for (const char* step : {"1e-2", "1e-3"}) {
        Trial& point = all.emplace_back(trial);
        point.label += fmt::format(" p={} dt={}", penalty, step);
        point.run.overrides.push_back(fmt::format("contact.initial_penalty_n_per_m2={}", penalty));
        point.run.overrides.push_back(fmt::format("analysis.step_s={}", step));
      }
    }
  }
  return all;
}

std::string number(const json& value) {
  return value.is_number() ? fmt::format("{:.9g}", value.get<double>()) : "none";
}

/// Prints the row of one figure.
void show(const std::string& label, const json& check, double wall_time_s, bool passed) {
  fmt::print(
      "{:<58} {:<34} {:>16} {:>16} {:>10} {:>10} {:>8.3g}{}\n", label, check["name"].get<std::string>(),
      number(check["expected"]), number(check["got"]),
      check["relative_error"].is_number() ? fmt::format("{:.2e}", check["relative_error"].get<double>()) : "none",
      number(check["tolerance"]), wall_time_s, passed ? "" : "  OUT");
  std::fflush(stdout);
}

}  // namespace

int validate(const ValidateOptions& options) {
  std::vector<Trial> all;  // a wrong scene is found before anything runs
  for (const fs::path& path : options.cases.empty() ? all_cases() : options.cases) {
    for (Trial& trial : trials(path, options)) all.push_back(std::move(trial));
  }
  if (!options.json.empty()) results::require_writable_file("--json", options.json);
  const TemporaryFolder scratch;
  json rows = json::array();
  bool sound = true;
  fmt::print("{:<58} {:<34} {:>16} {:>16} {:>10} {:>10} {:>8}\n", "case", "quantity", "expected", "got", "error",
             "tolerance", "time s");
  for (Trial& trial : all) {
    trial.run.out = scratch.path() / "run";
    const RunResult result = run(trial.run);
    if (result.exit_code != 0) fmt::print("{:<58} {}\n", trial.label, result.trouble);
    if (result.exit_code == 130) return 130;
    sound = sound && result.exit_code == 0;
    for (json check : result.summary.value("checks", json::array())) {
      const bool passed = result.exit_code == 0 && check["passed"].get<bool>();
      sound = sound && passed;
      show(trial.label, check, result.summary["wall_time_s"].get<double>(), passed);
      check["case"] = trial.label;
      check["wall_time_s"] = result.summary["wall_time_s"];
      rows.push_back(check);
    }
    fs::remove_all(result.folder);
  }
  if (rows.empty()) {
    fmt::print("no case states a figure\n");
    return 1;
  }
  if (!options.json.empty()) results::replace_file(options.json, rows.dump(2) + "\n");
  fmt::print("{} figures, {}\n", rows.size(), sound ? "all within tolerance" : "NOT all within tolerance");
  return sound ? 0 : 1;
}

}  // namespace blockweir::launch
