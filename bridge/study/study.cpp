// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bridge/process/programs.hpp"
#include "bridge/process/run.hpp"
#include "bridge/results/figure.hpp"
#include "bridge/results/file_name.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/collected_errors.hpp"
#include "bridge/scene/read/entry.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/ramp_ends.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/check_work.hpp"
#include "bridge/study/engines.hpp"
#include "bridge/study/open_study.hpp"
#include "bridge/study/study_files.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using process::RunOptions;
using process::RunResult;
using results::figure;

/// The scene's [[expect]] replaced by this one; texts in JSON's quotes are texts in TOML's.
std::string only_expectation(const scene::Expectation& e) {
  std::string entry = fmt::format("quantity={}", json(e.quantity).dump());
  if (e.value) entry += fmt::format(",value={}", *e.value);
  for (const auto& [key, text] : {std::pair{"word", e.word}, {"formula", e.formula}, {"of", e.of}}) {
    if (!text.empty()) entry += fmt::format(",{}={}", key, json(text).dump());
  }
  entry += fmt::format(",tolerance={}", e.tolerance);
  return "expect=[{" + entry + "}]";
}

/// Orders over the same key, beside each other.
void draw_orders(const std::vector<std::pair<std::string, StudyResult>>& orders, const fs::path& folder) {
  const bool one_key = std::all_of(orders.begin(), orders.end(),
                                   [&](const auto& order) { return order.second.key == orders.front().second.key; });
  if (orders.size() > 1 && one_key) draw_study(folder / "orders.png", "orders", orders_figure(orders));
}

/// What a scene asks for: studies with an answer, and those without.
struct Tasks {
  std::vector<StudyTask> answered;
  std::vector<OpenStudyTask> open;

  void keep(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& task : answered) names.push_back(task.name);
    for (const auto& task : open) names.push_back(task.name);
    std::erase_if(answered, [&](const auto& task) { return task.name != name; });
    std::erase_if(open, [&](const auto& task) { return task.name != name; });
    if (!answered.empty() || !open.empty()) return;
    const std::string meant = scene::did_you_mean(name, names);
    throw std::invalid_argument(fmt::format("the scene has no study \"{}\"; expected {}; {}", name,
                                            names.empty() ? "a scene with a [[study]]" : scene::one_of(names),
                                            !meant.empty()  ? meant
                                            : names.empty() ? "add one, or leave --name out"
                                                            : "name one of these, or leave --name out"));
  }
};

Tasks tasks_of(const StudyOptions& options) {
  const int jobs = jobs_of(options.engine);
  Tasks tasks;
  scene::CollectedErrors wrong;
  wrong.from([&] { tasks.answered = study_tasks(options.scene, options.overrides); });
  wrong.from([&] { tasks.open = open_study_tasks(options.scene, options.overrides, jobs); });
  wrong.report();
  if (!options.name.empty()) tasks.keep(options.name);
  if (tasks.answered.empty() && tasks.open.empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: found no study; expected [[study]], [[limit]], [[order]] or [[map]]; add one, or name another scene",
        options.scene.string()));
  }
  return tasks;
}

}  // namespace

StudyRuns::StudyRuns(const StudyTask& task, fs::path scene, Settings overrides, Listener on_run)
    : task_(task), scene_(std::move(scene)), overrides_(std::move(overrides)), on_run_(std::move(on_run)) {}

Attempt StudyRuns::attempt(const Settings& settings, const scene::Expectation& expected, double longest_s) {
  Attempt attempt;
  RunOptions options{.scene = scene_,
                     .out = scratch_.path() / "run",
                     .overrides = joined(joined(task_.set, overrides_), settings),
                     .quiet = true,
                     .longest_s = longest_s};
  options.overrides.push_back(only_expectation(expected));
  try {
    require_sound(task_, scene_, overrides_, settings);
    const RunResult result = process::run(options);
    if (result.exit_code == 130) throw Interrupted();
    attempt = {result.summary, result.trouble, result.refused, result.summary["wall_time_s"].get<double>()};
    const json checks = result.summary.value("checks", json::array());
    if (attempt.trouble.empty() && !checks.empty()) attempt.trouble = checks[0].value("trouble", "");
  } catch (const scene::SceneError& error) {
    attempt = {.trouble = error.what(), .refused = true};
  }
  wall_time_s_ += attempt.wall_time_s;
  on_run_(fmt::format("{}", fmt::join(settings, ", ")),
          attempt.trouble.empty() ? outcome_word(attempt.summary) : attempt.trouble);
  return attempt;
}

json StudyRuns::run(const Settings& settings, const scene::Expectation& expected) {
  Attempt attempt = this->attempt(settings, expected, /*longest_s=*/0);
  if (attempt.trouble.empty()) return std::move(attempt.summary);
  throw std::runtime_error(fmt::format("{}: {}", fmt::join(settings, ", "), attempt.trouble));
}

json StudyRuns::run_longer(Settings settings, double duration_s, const scene::Expectation& expected) {
  const scene::Scene own = scene::read(scene_, joined(joined(task_.set, overrides_), settings)).scene;
  settings = joined(std::move(settings), scene::ramp_ends(own));
  settings.push_back(setting("analysis.duration_s", duration_s));
  return run(settings, expected);
}

Settings joined(Settings first, const Settings& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string outcome_word(const json& summary) {
  const std::string outcome = summary.value("outcome", "stopped");
  return outcome == "fails" ? summary["failure"]["mode"].get<std::string>() : outcome;
}

std::string setting(const std::string& key, double value) {
  return fmt::format("{}={}", key, value);
}

void require_sound(const StudyTask& task, const fs::path& scene, const Settings& overrides, const Settings& settings) {
  scene::read_entry(scene, {fmt::format("{} \"{}\"", task.kind, task.name), task.line, joined(task.set, settings)},
                    joined(joined(task.set, overrides), settings));
}

std::vector<StudyTask> study_tasks(const fs::path& scene, const Settings& overrides) {
  const scene::Studies studies = scene::read(scene, overrides).scene.studies;
  std::vector<StudyTask> tasks;
  for (const auto& limit : studies.limits) tasks.push_back(limit_task(limit));
  for (const auto& order : studies.orders) tasks.push_back(order_task(order));
  for (const auto& map : studies.maps) tasks.push_back(map_task(map));
  scene::CollectedErrors wrong;
  for (const StudyTask& task : tasks) {
    for (const Settings& extreme : task.extremes) {
      wrong.from([&] { require_sound(task, scene, overrides, extreme); });
    }
  }
  wrong.report();
  return tasks;
}

StudyResult go(const StudyTask& task, const fs::path& scene, const Settings& overrides,
               const StudyRuns::Listener& on_run) {
  StudyRuns runs(task, scene, overrides, on_run);
  StudyResult result;
  try {
    result = task.go(runs);
  } catch (const std::runtime_error& error) {
    result.check = {
        {"name", "none"},       {"expected", nullptr}, {"got", nullptr},         {"relative_error", nullptr},
        {"tolerance", nullptr}, {"passed", false},     {"trouble", error.what()}};
  }
  result.check["wall_time_s"] = runs.wall_time_s();
  return result;
}

void print_study(const std::string& name, const StudyResult& result, const fs::path& out) {
  const json& check = result.check;
  fmt::print("{}\n{}", name, result.text);
  if (check.contains("trouble")) {
    fmt::print("STOPPED {}\n", check["trouble"].get<std::string>());
    return;
  }
  fmt::print("{}",
             results::for_stdout(fmt::format(
                 "{} {}: expected {}, got {}, off by {} (tolerance {})\n", check["passed"].get<bool>() ? "ok " : "OUT",
                 check["name"].get<std::string>(), figure(check["expected"]), figure(check["got"]),
                 figure(check["relative_error"]), figure(check["tolerance"]))));
  std::fflush(stdout);
  if (out.empty()) return;
  const fs::path file = out / results::file_name(name);
  const json table = {{"name", name}, {"check", check}, {"runs", result.runs}};
  results::replace_file(file.string() + ".json", table.dump(2) + "\n");
  fmt::print("{}.json\n", file.string());
  draw_study(file.string() + ".png", name, result.figure);
}

int perform_all(const StudyOptions& options) {
  const Tasks tasks = tasks_of(options);
  refuse_idle_overrides(tasks.open, options.scene, options.overrides);
  fs::path open_out = options.out;  // finished runs must be stored, so that the study can be continued
  if (open_out.empty()) open_out = fs::path("runs") / (process::case_name(options.scene) + "-studies");
  if (!options.out.empty()) results::make_folder(options.out);
  if (!tasks.open.empty()) results::make_folder(open_out);
  const auto engine = make_engine(options.engine, open_out);
  bool sound = true;
  std::vector<std::pair<std::string, StudyResult>> orders;
  try {
    engine::Work work{.name = "studies", .common = {{"by", "check"}}, .items = {}};
    for (const StudyTask& task : tasks.answered) {
      work.items.push_back(study_item(options.scene, task.name, options.overrides, /*brief=*/false, /*reported=*/true));
    }
    perform_in_order(*engine, work, [&](std::size_t i, const json& answer) {
      StudyResult result = study_result(answer);
      print_study(tasks.answered[i].name, result, options.out);
      sound = sound && result.check["passed"].get<bool>();
      if (result.key.empty() || result.check.contains("trouble")) return;
      orders.emplace_back(tasks.answered[i].name, std::move(result));
    });
    for (const OpenStudyTask& task : tasks.open) {
      sound = perform(task, options.scene, options.overrides, open_out, *engine) && sound;
    }
  } catch (const Interrupted&) {
    fmt::print(stderr, "stopped on request{}\n",
               tasks.open.empty()
                   ? ""
                   : "; the runs of each [[study]] that are done are kept, and the same command makes the others");
    return 130;
  }
  if (!options.out.empty()) draw_orders(orders, options.out);
  return sound ? 0 : 1;
}

}  // namespace blockweir::study
