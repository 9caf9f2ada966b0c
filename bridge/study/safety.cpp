// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "bridge/picture/mechanism.hpp"
#include "bridge/picture/section_state.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/results/file_name.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/overrides.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/read/stated_loads.hpp"
#include "bridge/study/load_case_scene.hpp"
#include "bridge/study/safety_text.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Has every case an answer, and is every factor that is required reached?
bool all_enough(const json& cases) {
  return std::all_of(cases.begin(), cases.end(), [](const json& c) {
    return c["outcome"] != "not found" && !c.contains("contradiction") &&
           (c["required"].is_null() || c["satisfied"] == true);
  });
}

/// Loads that a factor on the stated loads does not change.
std::vector<std::string> constant_loads(const scene::Scene& scene) {
  std::vector<std::string> all{"weight"};
  if (!scene.bolts.empty()) all.emplace_back("bolts");
  if (scene.fluid != scene::FluidModel::none) all.emplace_back("water");
  if (scene.water.ice) all.emplace_back("ice");
  if (scene.water.is_shaken()) all.emplace_back("the earthquake's added water");
  return all;
}

/// Is one of two keys the other, or a table that holds it?
bool meet(const std::string& a, const std::string& b) {
  const auto& [shorter, longer] = std::minmax(a, b, [](const auto& x, const auto& y) { return x.size() < y.size(); });
  return longer == shorter || longer.starts_with(shorter + ".");
}

/// Of the command line's settings, those over which the load case goes with its own.
std::vector<std::string> without_effect(const Settings& overrides, const scene::LoadCase& load_case) {
  std::vector<std::string> warnings;
  for (const std::string& setting : overrides) {
    for (const std::string& own : load_case.set) {
      if (!meet(scene::setting_key(setting), scene::setting_key(own))) continue;
      warnings.push_back(fmt::format("--set {} is not what counts here: the load case sets {}", setting, own));
    }
  }
  return warnings;
}

using Pictures = std::vector<std::function<void()>>;

/// The answer, for the load case that asks for it.
json named(json answer, const scene::LoadCase& load_case) {
  answer["name"] = load_case.name;
  answer["class"] = load_case.kind;
  answer["set"] = load_case.set;
  answer["required"] = load_case.required_factor ? json(*load_case.required_factor) : json();
  answer["source"] = load_case.source;
  answer["satisfied"] = satisfied(answer, load_case.required_factor);
  return answer;
}

/// Evaluates one case and adds the drawing of its mechanisms and the scene's remarks.
json answer_of(const scene::LoadCase& load_case, const process::AskOptions& options, Pictures& pictures) {
  const process::Asked asked = process::ask("safety", options);
  json answer = asked.answer;
  const auto draw = [&](const json& found, const char* name) {
    const std::optional<double> level_m =
        answer["level_m"].is_number() ? std::optional(answer["level_m"].get<double>()) : std::nullopt;
    if (!found.contains("mechanism")) return;
    pictures.emplace_back([scene = asked.scene, mechanism = found["mechanism"], level_m, file = asked.folder / name] {
      picture::draw_mechanism(scene, mechanism, level_m, file);
    });
  };
  draw(answer, "mechanism.png");
  draw(answer.value("load_factor", json::object()), "mechanism-loads.png");
  if (answer.contains("load_factor")) {
    answer["load_factor"]["loads"] = scene::stated_loads(asked.scene);
    answer["load_factor"]["constant"] = constant_loads(asked.scene);
  }
  json bolt_forces = json::array();
  for (const json& bolt : answer["bolts"]) bolt_forces.push_back(bolt["force_n_per_m"]);
  answer["section"] =
      picture::section_state(asked.scene, answer["water"], asked.scene.analysis.duration_s, bolt_forces);
  answer["scene_warnings"] = asked.scene.warnings;
  answer["silt_ice_and_earthquake"] = scene::silt_ice_and_earthquake(asked.scene.text);
  return named(std::move(answer), load_case);
}

}  // namespace

json satisfied(const json& answer, const std::optional<double>& required) {
  if (!required) return nullptr;
  if (answer["outcome"] != "not found") return deciding_factor(answer) >= *required;
  const json& at_most = answer["limit_analysis_factor"];
  return at_most.is_number() && at_most < *required ? json(false) : json();
}

double deciding_factor(const json& answer) {
  double factor = answer["outcome"] == "stands" ? std::numeric_limits<double>::infinity() : 0;
  if (answer["factor"].is_number()) factor = answer["factor"];
  if (answer["limit_analysis_factor"].is_number())
    factor = std::min(factor, answer["limit_analysis_factor"].get<double>());
  for (const char* lower : {"with_crushed_corners", "with_cracked_joint", "with_rigid_blocks", "with_straining_blocks",
                            "with_blocks_reordered", "above_upper_bound"}) {
    if (answer.contains(lower)) factor = std::min(factor, answer[lower]["factor"].get<double>());
  }
  return factor;
}

void safety_answers(const process::AskOptions& options, json& cases, Pictures* pictures) {
  const scene::ReadScene read = scene::read_variant(options.scene, options.variant, options.overrides);
  scene::CollectedErrors wrong;
  for (const scene::LoadCase& load_case : read.load_cases) {
    wrong.from([&] { load_case_scene(load_case, options.scene, options.overrides); });
  }
  wrong.report();
  process::make_answer_folder(options.out);
  const results::FolderLock until_the_last_case(options.out);
  Pictures own;
  const auto answer = [&](const scene::LoadCase& load_case, const fs::path& out, bool quiet) {
    process::AskOptions one = options;
    one.out = out;
    one.overrides = joined(options.overrides, load_case.set);
    one.quiet = quiet;
    one.tells_progress = options.tells_progress || !options.quiet;
    json found = answer_of(load_case, one, pictures != nullptr ? *pictures : own);
    for (const auto& draw : std::exchange(own, {})) draw();
    const scene::Scene with = scene::read_variant(one.scene, one.variant, one.overrides).scene;
    const auto idle = idle_load_case(load_case, read.scene, with);
    if (idle) found["warnings"].push_back(idle->message());
    for (const scene::Diagnostic& missed : missed_joints(load_case, with)) {
      found["warnings"].push_back(missed.message());
    }
    for (std::string& warning : without_effect(options.overrides, load_case)) {
      found["warnings"].push_back(std::move(warning));
    }
    cases.push_back(std::move(found));
  };
  answer({.name = "scene as written"}, options.out, options.quiet);
  for (const scene::LoadCase& load_case : read.load_cases) {
    if (load_case.set.empty()) {  // the scene as written, which has been answered
      cases.push_back(named(cases[0], load_case));
      continue;
    }
    answer(load_case, options.out / results::file_name(load_case.name), /*quiet=*/true);
  }
}

int print_safety(const SafetyOptions& options) {
  if (!options.json.empty()) results::require_writable_file("--json", options.json, {".json"});
  process::AskOptions question = options;
  question.out = process::answer_folder("safety", options);
  const fs::path& folder = question.out;
  Pictures pictures;
  json cases = json::array();
  try {
    safety_answers(question, cases, &pictures);
  } catch (const process::Stopped&) {
    if (!cases.empty())
      fmt::print("{}stopped before the next load case was answered\n",
                 results::for_stdout(safety_text(cases, "all of these")));
    throw;
  }
  // The answers are printed first: they took the time, and the disk may be full for files and pictures.
  fmt::print("{}", results::for_stdout(safety_text(cases)));
  const std::string all = json{{"load_cases", cases}}.dump(2) + "\n";
  fs::remove(folder / "safety.json");  // so far of the first case alone: none is better than that
  results::replace_file(folder / "safety.json", all);
  if (!options.json.empty()) results::replace_file(options.json, all);
  for (const auto& draw : pictures) draw();
  const char* drawn = cases[0].contains("mechanism") ? ", mechanism.png" : "";
  fmt::print("{}", results::for_stdout(
                       fmt::format("results {} (safety.json{}; a folder for each load case that changes the scene)\n",
                                   folder.string(), drawn)));
  return all_enough(cases) ? 0 : 1;
}

}  // namespace blockweir::study
