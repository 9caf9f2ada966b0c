// SPDX-License-Identifier: GPL-3.0-or-later
// Studies: many runs of a scene with changed keys, whose result is compared with a stated one.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/process/temporary_folder.hpp"
#include "bridge/scene/scene.hpp"
#include "bridge/study/engine_options.hpp"

namespace blockweir::study {

using Settings = std::vector<std::string>;  ///< "dotted.key=value" each

/// Ctrl-C was pressed.
struct Interrupted {};

/// Result of a study.
struct StudyResult {
  nlohmann::json check;                           ///< as for a run: name, expected, got, relative_error, ...
  nlohmann::json runs = nlohmann::json::array();  ///< settings and result of each run
  std::string text;                               ///< about the runs, for the user
  std::string figure;                             ///< gnuplot's commands, without terminal and output
  std::string key{};                              ///< for an order of convergence, the key; otherwise empty
};

/// The end of one run of a study.
struct Attempt {
  nlohmann::json summary;
  std::string trouble;   ///< why it failed; empty: it did not
  bool refused = false;  ///< it failed by itself with a message, or its scene is invalid
  double wall_time_s = 0;
};

/// A study that is ready to start.
struct StudyTask;

/// Makes the runs of a study; each run removes the previous one.
class StudyRuns {
 public:
  using Listener = std::function<void(const std::string& settings, const std::string& outcome)>;
  /// `overrides` of the command line replace the study's settings; `on_run` is called for each run.
  StudyRuns(const StudyTask& task, std::filesystem::path scene, Settings overrides, Listener on_run);

  /// Runs the scene with `settings` and only `expected` to check; ends it if it takes longer. Throws Interrupted.
  Attempt attempt(const Settings& settings, const scene::Expectation& expected, double longest_s);

  /// Its summary. Throws std::runtime_error if the run fails, and Interrupted.
  nlohmann::json run(const Settings& settings, const scene::Expectation& expected);
  /// The same with another duration: ramps keep the value that they reach at the end of the scene's own duration.
  nlohmann::json run_longer(Settings settings, double duration_s, const scene::Expectation& expected);

  [[nodiscard]] double wall_time_s() const { return wall_time_s_; }

 private:
  const StudyTask& task_;
  std::filesystem::path scene_;
  Settings overrides_;
  Listener on_run_;
  process::TemporaryFolder scratch_;
  double wall_time_s_ = 0;
};

struct StudyTask {
  std::string name;
  const char* kind;                ///< [[limit]], [[order]] or [[map]]
  int line = 0;                    ///< where the scene file states it
  Settings set;                    ///< in all its runs
  std::vector<Settings> extremes;  ///< settings for which the scene must be valid
  std::function<StudyResult(StudyRuns&)> go;
};

/// Reads and checks the scene with the settings of one run. Throws scene::SceneError that names the study.
void require_sound(const StudyTask& task, const std::filesystem::path& scene, const Settings& overrides,
                   const Settings& settings);

StudyTask limit_task(const scene::LimitStudy& study);
StudyTask order_task(const scene::OrderStudy& study);
StudyTask map_task(const scene::MapStudy& study);

/// Errors of several order studies over their keys in one picture, by name of study: gnuplot's commands as above.
std::string orders_figure(const std::vector<std::pair<std::string, StudyResult>>& orders);

/// All studies of a scene, each setting checked. Throws scene::SceneError if the scene is invalid with one of them.
std::vector<StudyTask> study_tasks(const std::filesystem::path& scene, const Settings& overrides);

/// The settings of both, `first` first.
Settings joined(Settings first, const Settings& second);

/// Makes the study's runs. If one fails, the check fails and has the reason as "trouble".
StudyResult go(const StudyTask& task, const std::filesystem::path& scene, const Settings& overrides,
               const StudyRuns::Listener& on_run);

/// Prints the result of a study: figures and their check on standard output; if a folder is given, also a table and a
/// figure there.
void print_study(const std::string& name, const StudyResult& result, const std::filesystem::path& out);

/// "stands", "stopped", or the mode of the first failure.
std::string outcome_word(const nlohmann::json& summary);

/// "key=value", with the value in TOML syntax.
std::string setting(const std::string& key, double value);

struct StudyOptions {
  std::filesystem::path scene;
  std::string name;           ///< empty: all studies of the scene
  std::filesystem::path out;  ///< folder for figures and tables; empty: none, and runs/CASE-studies for [[study]]
  EngineOptions engine;
  Settings overrides;
};

/// blockweir study: returns 0 if every figure is within its tolerance and every [[study]] has a result, otherwise 1.
int perform_all(const StudyOptions& options);

}  // namespace blockweir::study
