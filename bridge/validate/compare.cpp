// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/compare.hpp"

#include <fmt/format.h>

#include "bridge/process/previous_run.hpp"
#include "bridge/process/run.hpp"
#include "bridge/results/figure.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/diagnostic.hpp"
#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/study.hpp"
#include "bridge/validate/cases_folder.hpp"
#include "bridge/validate/compared_run.hpp"
#include "bridge/validate/table_line.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using process::run;
using process::RunOptions;
using process::RunResult;
using process::TemporaryFolder;

constexpr std::array formulations = {"penalty", "lagrange-multiplier", "augmented-lagrangian"};
constexpr std::array usual_cases = {"incline", "column", "monolith-slides", "cracked-dam-upper", "cracked-dam-lower"};

std::vector<fs::path> chosen(const CompareOptions& options) {
  if (!options.cases.empty()) return options.cases;
  std::vector<fs::path> cases;
  for (const char* name : usual_cases) cases.push_back(cases_folder() / name);
  return cases;
}

/// What is wrong with a scene as it stands is told once, and before any run.
void refuse_wrong_scenes(const std::vector<fs::path>& scenes) {
  scene::CollectedErrors wrong;
  for (const fs::path& scene : scenes) wrong.from([&] { scene::read(scene); });
  wrong.report();
}

/// Two runs: one for the time, and one with condition numbers, which take far longer than the run.
json measured(const std::string& name, RunOptions options) {
  try {
    const RunResult timed = uninterrupted(name + ": a run for the time", options);
    if (timed.exit_code != 0) return {{"trouble", timed.trouble}};
    options.overrides.emplace_back("contact.measure_condition=true");
    options.out += "-conditioned";
    const RunResult conditioned =
        uninterrupted(name + ": a run that measures condition numbers, which takes far longer", options);
    fs::remove_all(options.out);
    if (conditioned.exit_code != 0) return {{"trouble", "with contact.measure_condition: " + conditioned.trouble}};
    json summary = timed.summary;
    summary["largest_condition_number"] = conditioned.summary.value("largest_condition_number", json());
    return summary;
  } catch (const scene::SceneError& error) {
    return {{"trouble", error.what()}};
  }
}

std::string number(const json& value, const char* format) {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "none";
}

void print_run(const std::string& name, const std::string& penetration, const std::string& condition,
               const std::string& systems, const std::string& steps, const std::string& retried,
               const std::string& time) {
  fmt::print("{}", table_line(name, fmt::format("{:>11} {:>9} {:>7} {:>6} {:>7} {:>7}", penetration, condition, systems,
                                                steps, retried, time)));
}

/// Prints a run and its figures, and adds these to `rows`; false where there are none.
bool add_rows(const std::string& name, const char* formulation, const std::string& command, const json& s, json& rows) {
  if (s.contains("trouble")) {
    fmt::print("  {}\n{}{}", formulation, results::wrapped("    " + s["trouble"].get<std::string>()),
               results::wrapped("    repeat it with " + command));
    rows.push_back({{"case", name}, {"formulation", formulation}, {"trouble", s["trouble"]}, {"command", command}});
    return false;
  }
  const json& counts = s["counts"];
  print_run(fmt::format("  {}", formulation), number(s["largest_penetration_m"], "{:.2e}"),
            number(s["largest_condition_number"], "{:.2e}"), counts["iterations"].dump(), counts["steps"].dump(),
            counts["substituted_steps"].dump(), number(s["wall_time_s"], "{:.3g}"));
  for (const json& check : figures(s)) {
    print_figure(check["name"].get<std::string>(), results::figure(check["got"]),
                 number(check["relative_error"], "{:.2e}"));
    rows.push_back({{"case", name},
                    {"formulation", formulation},
                    {"name", check["name"]},
                    {"expected", check["expected"]},
                    {"got", check["got"]},
                    {"relative_error", check["relative_error"]},
                    {"largest_penetration_m", s["largest_penetration_m"]},
                    {"largest_condition_number", s["largest_condition_number"]},
                    {"iterations", s["counts"]["iterations"]},
                    {"multiplier_sweeps", s["counts"]["multiplier_sweeps"]},
                    {"steps", s["counts"]["steps"]},
                    {"substituted_steps", s["counts"]["substituted_steps"]},
                    {"wall_time_s", s["wall_time_s"]},
                    {"command", command}});
  }
  return true;
}

}  // namespace

int compare(const CompareOptions& options) {
  for (const fs::path& scene : options.cases) {
    const std::string found = process::answers_in(scene);
    if (!found.empty()) fmt::print(stderr, "{}: these are {}: their scene is run\n", scene.string(), found);
  }
  refuse_wrong_scenes(options.cases);
  if (!options.fluids.empty()) return compare_fluids(options);
  if (!options.json.empty()) results::require_writable_file("--json", options.json, {".json"});
  if (!options.out.empty()) results::make_folder(options.out);
  const TemporaryFolder scratch;
  json rows = json::array();
  bool sound = true;
  print_run("case, formulation", "penetration", "condition", "systems", "steps", "retried", "time s");
  print_figure("quantity", "got", "error");
  try {
    for (const fs::path& scene : chosen(options)) {
      fmt::print("{}\n", case_name(scene));
      for (const char* formulation : formulations) {
        const std::string name = fmt::format("{}-{}", case_name(scene), formulation);
        RunOptions one{.scene = scene,
                       .out = options.out.empty() ? scratch.path() / "run" : options.out / name,
                       .overrides = options.overrides};
        one.overrides.push_back(fmt::format("contact.formulation={}", formulation));
        sound &= add_rows(case_name(scene), formulation, command_of(one),
                          measured(fmt::format("{}, {}", case_name(scene), formulation), one), rows);
        std::fflush(stdout);
      }
    }
  } catch (const Interrupted&) {
    fmt::print(stderr, "stopped on request\n");
    return 130;
  }
  if (!options.json.empty()) results::replace_file(options.json, rows.dump(2) + "\n");
  std::error_code kept;
  fs::remove(options.out, kept);  // where no run has left anything in it
  return sound ? 0 : 1;
}

}  // namespace blockweir::study
