// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/open_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "bridge/results/csv.hpp"
#include "bridge/results/figure.hpp"
#include "bridge/results/file_name.hpp"
#include "bridge/results/folder_lock.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/entry.hpp"
#include "bridge/scene/read/overrides.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/study_files.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::array table_columns = {
    "outcome", "mode",           "joint",  "level_m",     "level_uncertainty_m", "level_is_bound", "head_m",
    "time_s",  "sliding_factor", "factor", "simulated_s", "wall_time_s",         "trouble"};

std::string cell(const json& value) {
  if (value.is_null()) return "";
  if (value.is_number_float()) return fmt::format("{}", results::without_rounding_error(value));
  return value.is_string() ? results::csv_cell(value.get<std::string>()) : value.dump();
}

OpenStudyTask task_of(const scene::OpenStudy& study, const fs::path& scene, int jobs) {
  if (std::holds_alternative<scene::CriticalValue>(study.question)) return critical_task(study, jobs);
  if (std::holds_alternative<scene::OutcomeMap>(study.question)) return outcome_map_task(study);
  return sample_task(study, scene);
}

/// Whether the reservoir's level is constant: then there is no failure level, and no doubt about it.
bool level_is_fixed(const OpenStudyTask& task, const fs::path& scene, const Settings& overrides) {
  for (const Settings& extreme : task.extremes) {
    try {
      const auto level = scene::read(scene, joined(joined(task.set, overrides), extreme)).scene.water.upstream_level_m;
      return level && !level->sine &&
             std::all_of(level->value.begin(), level->value.end(), [&](double v) { return v == level->value.front(); });
    } catch (const scene::SceneError&) {  // a draw that is refused: the next one tells
    }
  }
  return false;
}

/// Warnings of the runs on their levels, with the first run that warns; empty if none does.
std::string levels_in_doubt(const std::vector<Outcome>& runs) {
  const auto in_doubt = [](const Outcome& run) { return run.value("level_doubt", json()).is_string(); };
  const auto first = std::find_if(runs.begin(), runs.end(), in_doubt);
  if (first == runs.end()) return "";
  return fmt::format("  WARNING {} of {} runs doubt their level (see level_uncertainty_m and level_is_bound); {}: {}\n",
                     std::count_if(runs.begin(), runs.end(), in_doubt), runs.size(),
                     fmt::join((*first)["settings"].get<Settings>(), ", "), (*first)["level_doubt"].get<std::string>());
}

/// How many runs have no answer, with the first that has none; empty where all have one.
std::string unanswered(const std::vector<Outcome>& runs) {
  const auto first = std::find_if_not(runs.begin(), runs.end(), has_answer);
  if (first == runs.end()) return "";
  return fmt::format("  NONE    {} of {} runs have no answer; {}: {}; the same command makes them again\n",
                     std::count_if(runs.begin(), runs.end(), std::not_fn(has_answer)), runs.size(),
                     fmt::join((*first)["settings"].get<Settings>(), ", "), (*first).value("trouble", "stopped"));
}

/// What was done before a stop, in the order in which it ended.
std::vector<Outcome> kept_runs(const fs::path& file) {
  std::vector<Outcome> runs;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    json row = json::parse(line, nullptr, /*allow_exceptions=*/false);
    if (row.is_object()) runs.push_back(std::move(row));
  }
  return runs;
}

void write_results(const OpenStudyTask& task, const fs::path& scene, const Finding& finding, const fs::path& file) {
  results::replace_file(file.string() + ".csv", outcome_table(task.keys, finding.runs));
  const json all = {
      {"name", task.name},        {"kind", task.kind},    {"scene", scene.string()},     {"set", task.set},
      {"answer", finding.answer}, {"runs", finding.runs}, {"version", BLOCKWEIR_VERSION}};
  results::replace_file(file.string() + ".json", all.dump(2) + "\n");
  draw_study(file.string() + ".png", task.name, finding.figure);
}

}  // namespace

std::string shown_word(const Outcome& outcome) {
  if (const json factor = outcome.value("factor", json()); factor.is_number()) {
    return fmt::format("factor {:.5g}", factor.get<double>());
  }
  const json mode = outcome.value("mode", json());
  return mode.is_string() ? mode : outcome["outcome"];
}

std::string value_in(const Outcome& outcome, const std::string& key) {
  for (const json& entry : outcome["settings"]) {
    const std::string text = entry;
    if (text.starts_with(key + "=")) return text.substr(key.size() + 1);
  }
  return "";
}

std::string outcome_table(const Settings& keys, const std::vector<Outcome>& runs) {
  std::string text = "run";
  for (const std::string& key : keys) text += "," + results::csv_cell(key);
  for (const char* column : table_columns) text += fmt::format(",{}", column);
  text += "\n";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    text += std::to_string(i + 1);
    for (const std::string& key : keys) text += "," + results::csv_cell(value_in(runs[i], key));
    for (const char* column : table_columns) text += "," + cell(runs[i].value(column, json()));
    text += "\n";
  }
  return text;
}

/// Throws scene::SceneError if the scene is invalid with an extreme setting; for random samples, only if with all.
static void require_sound(const OpenStudyTask& task, const fs::path& scene, const Settings& overrides) {
  scene::CollectedErrors wrong;
  bool some_sound = false;
  for (const Settings& extreme : task.extremes) {
    const scene::SettingEntry entry{fmt::format("[[study]] \"{}\"", task.name), task.line, joined(task.set, extreme)};
    wrong.from([&] {
      scene::read_entry(scene, entry, joined(joined(task.set, overrides), extreme));
      some_sound = true;
    });
  }
  if (!task.may_refuse || !some_sound) wrong.report();
}

std::vector<OpenStudyTask> open_study_tasks(const fs::path& scene, const Settings& overrides, int jobs) {
  std::vector<OpenStudyTask> tasks;
  scene::CollectedErrors wrong;
  for (const scene::OpenStudy& study : scene::read(scene, overrides).open_studies) {
    wrong.from([&] { tasks.push_back(task_of(study, scene, jobs)); });
  }
  for (OpenStudyTask& task : tasks) {
    wrong.from([&] { require_sound(task, scene, overrides); });
  }
  wrong.report();
  return tasks;
}

void refuse_idle_overrides(const std::vector<OpenStudyTask>& tasks, const fs::path& scene, const Settings& overrides) {
  if (tasks.empty() || overrides.empty()) return;
  const scene::Scene read = scene::read(scene, overrides).scene;
  scene::CollectedErrors wrong;
  for (const OpenStudyTask& task : tasks) {
    for (const std::string& idle : scene::overrides_of(read, overrides, task.keys)) {
      wrong.add({scene::Diagnostic::Severity::error, scene::override_place(idle), 0,
                 fmt::format("[[study]] \"{}\" varies this key, so that it would have no effect", task.name),
                 "keys that the study does not vary", "leave it out, or make another study with --name"});
    }
  }
  wrong.report();
}

bool perform(const OpenStudyTask& task, const fs::path& scene, const Settings& overrides, const fs::path& out,
             engine::Engine& engine) {
  const results::FolderLock lock(out);
  const fs::path file = out / results::file_name(task.name);
  const fs::path kept = file.string() + ".runs.jsonl";
  OutcomeRuns runs({.name = task.name,
                    .scene = scene,
                    .set = task.set,
                    .overrides = overrides,
                    .kept = kept,
                    .by = task.of_factor ? "factor" : "run",
                    .until_decided = task.until_decided},
                   engine);
  Finding finding;
  try {
    finding = task.find(runs);
  } catch (const Interrupted&) {
    results::replace_file(file.string() + ".csv", outcome_table(task.keys, kept_runs(kept)));
    throw;
  } catch (const std::runtime_error& error) {
    fmt::print("{}", results::for_stdout(fmt::format("{}\nSTOPPED {}\n", task.name, error.what())));
    return false;
  }
  const bool fixed = level_is_fixed(task, scene, overrides);
  const std::string none = unanswered(finding.runs);
  fmt::print(
      "{}", results::for_stdout(task.name + "\n" + finding.text + (fixed ? "" : levels_in_doubt(finding.runs)) + none));
  write_results(task, scene, finding, file);
  fmt::print("{0}.csv\n{0}.json\n", file.string());
  return none.empty();
}

}  // namespace blockweir::study
