// SPDX-License-Identifier: GPL-3.0-or-later
// [[study]]: a critical value, a map of outcomes, or a sample. The scene states no result; the study finds it.
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

/// Result of a study.
struct Finding {
  nlohmann::json answer;      ///< content of NAME.json
  std::vector<Outcome> runs;  ///< in the order of the table
  std::string text;           ///< for the user
  std::string figure;         ///< gnuplot's commands, without terminal and output
};

struct OpenStudyTask {
  std::string name;
  const char* kind = "";
  int line = 0;
  Settings set{};
  Settings keys{};                   ///< columns of the table
  std::vector<Settings> extremes{};  ///< settings for which the scene must be valid
  bool may_refuse = false;           ///< an invalid scene is accepted as a result, as for random samples
  bool until_decided = false;
  bool of_factor = false;
  /// Throws std::runtime_error if there is no answer.
  std::function<Finding(OutcomeRuns&)> find{};
};

OpenStudyTask critical_task(const scene::OpenStudy& study, int jobs);
OpenStudyTask outcome_map_task(const scene::OpenStudy& study);
OpenStudyTask sample_task(const scene::OpenStudy& study, const std::filesystem::path& scene);

/// All [[study]] of a scene, each checked with its extreme settings. Throws scene::SceneError if the scene is invalid.
std::vector<OpenStudyTask> open_study_tasks(const std::filesystem::path& scene, const Settings& overrides, int jobs);

/// Throws scene::SceneError if an override sets a key that one of the studies varies: it would have no effect.
void refuse_idle_overrides(const std::vector<OpenStudyTask>& tasks, const std::filesystem::path& scene,
                           const Settings& overrides);

/// Makes the runs that are not done yet and writes NAME.csv, NAME.json and NAME.png to the existing folder `out`.
/// Prints the result on standard output and the runs on standard error. If stopped, it leaves the table of finished
/// runs and throws Interrupted. Returns false if there is no answer, or if a run has none.
bool perform(const OpenStudyTask& task, const std::filesystem::path& scene, const Settings& overrides,
             const std::filesystem::path& out, engine::Engine& engine);

/// One row for each run: number, values of the keys, outcome. Cells of missing figures are empty.
std::string outcome_table(const Settings& keys, const std::vector<Outcome>& runs);

/// "sliding", "stands", "refused": the word of an outcome in a map.
std::string shown_word(const Outcome& outcome);

/// The value of `key` in the run, as text.
std::string value_in(const Outcome& outcome, const std::string& key);

}  // namespace blockweir::study
