// SPDX-License-Identifier: GPL-3.0-or-later
// [[study]]: a critical value, a map of outcomes, a sample. Nobody states an answer; the study finds one.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/scene/open_study.hpp"
#include "bridge/study/outcome_runs.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// What a study has found.
struct Finding {
  nlohmann::json answer;      ///< as NAME.json has it
  std::vector<Outcome> runs;  ///< in the order of the table
  std::string text;           ///< for people
  std::string figure;         ///< gnuplot's commands, without terminal and output
};

struct OpenStudyTask {
  std::string name;
  const char* kind = "";
  int line = 0;
  Settings set{};
  Settings keys{};                   ///< columns of the table
  std::vector<Settings> extremes{};  ///< settings that the scene has to be sound with
  bool may_refuse = false;           ///< a scene that is not sound with all of them is a result, as of a draw
  bool until_decided = false;
  bool of_factor = false;
  /// Throws std::runtime_error where there is no answer.
  std::function<Finding(OutcomeRuns&)> find{};
};

OpenStudyTask critical_task(const scene::OpenStudy& study, int jobs);
OpenStudyTask outcome_map_task(const scene::OpenStudy& study);
OpenStudyTask sample_task(const scene::OpenStudy& study, const std::filesystem::path& scene);

/// All [[study]] of a scene, each setting at its ends checked. Throws scene::SceneError when the scene is not sound.
std::vector<OpenStudyTask> open_study_tasks(const std::filesystem::path& scene, const Settings& overrides, int jobs);

/// Throws scene::SceneError where an override sets what one of the studies varies: it would have no effect.
void refuse_idle_overrides(const std::vector<OpenStudyTask>& tasks, const std::filesystem::path& scene,
                           const Settings& overrides);

/// Makes the runs that are not done yet and writes NAME.csv, NAME.json and NAME.png to `out`, which is there; tells the
/// finding on standard output and the runs on standard error. Stopped, it leaves the table of what is done, and throws
/// Interrupted. False where there is no answer, or a run has none.
bool perform(const OpenStudyTask& task, const std::filesystem::path& scene, const Settings& overrides,
             const std::filesystem::path& out, engine::Engine& engine);

/// One row a run: its number, what the keys were set to, how it ended. Empty cells where it has no such figure.
std::string outcome_table(const Settings& keys, const std::vector<Outcome>& runs);

/// "sliding", "stands", "refused": what a map shows of an outcome.
std::string shown_word(const Outcome& outcome);

/// What `key` was set to in the run, as text.
std::string value_in(const Outcome& outcome, const std::string& key);

}  // namespace blockweir::study
