// SPDX-License-Identifier: GPL-3.0-or-later
// Studies: many runs of a scene with keys set otherwise, whose figure is held against an answer.
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

/// Somebody has pressed Ctrl-C.
struct Interrupted {};

/// What a study found.
struct StudyResult {
  nlohmann::json check;                           ///< as those of a run: name, expected, got, relative_error, ...
  nlohmann::json runs = nlohmann::json::array();  ///< what each run was set to and gave
  std::string text;                               ///< of the runs, for people
  std::string figure;                             ///< gnuplot's commands, without terminal and output
  std::string key{};                              ///< over which an order has been measured; else empty
};

/// How one run of a study has ended.
struct Attempt {
  nlohmann::json summary;
  std::string trouble;   ///< why it failed, else empty
  bool refused = false;  ///< when it failed: it ended by itself, or its scene is not sound
  double wall_time_s = 0;
};

/// A study that is ready to go.
struct StudyTask;

/// Makes the runs of a study; each forgets the one before.
class StudyRuns {
 public:
  using Listener = std::function<void(const std::string& settings, const std::string& outcome)>;
  /// `overrides` of the command line go over what the study sets; `heard` is told of each run.
  StudyRuns(const StudyTask& task, std::filesystem::path scene, Settings overrides, Listener heard);

  /// The scene with `settings`, whose only check is `expected`, ended when it takes longer. Throws Interrupted.
  Attempt attempt(const Settings& settings, const scene::Expectation& expected, double longest_s);

  /// Its summary. Throws std::runtime_error when the run fails, and Interrupted.
  nlohmann::json run(const Settings& settings, const scene::Expectation& expected);
  /// The same over another duration: what rises or falls holds the value that it has where the scene's own one ends.
  nlohmann::json run_longer(Settings settings, double duration_s, const scene::Expectation& expected);

  [[nodiscard]] double wall_time_s() const { return wall_time_s_; }

 private:
  const StudyTask& task_;
  std::filesystem::path scene_;
  Settings overrides_;
  Listener heard_;
  process::TemporaryFolder scratch_;
  double wall_time_s_ = 0;
};

struct StudyTask {
  std::string name;
  const char* kind;                ///< [[limit]], [[order]] or [[map]]
  int line = 0;                    ///< where the scene file states it
  Settings set;                    ///< holds in all its runs
  std::vector<Settings> extremes;  ///< settings that the scene has to be sound with
  std::function<StudyResult(StudyRuns&)> go;
};

/// The scene with settings of one of its runs, checked. Throws scene::SceneError that names the study.
void require_sound(const StudyTask& task, const std::filesystem::path& scene, const Settings& overrides,
                   const Settings& settings);

StudyTask limit_task(const scene::LimitStudy& study);
StudyTask order_task(const scene::OrderStudy& study);
StudyTask map_task(const scene::MapStudy& study);

/// Errors of several orders over their key in one picture, by the studies' names: gnuplot's commands as above.
std::string orders_figure(const std::vector<std::pair<std::string, StudyResult>>& orders);

/// All studies of a scene, each setting checked. Throws scene::SceneError when the scene is not sound with one.
std::vector<StudyTask> study_tasks(const std::filesystem::path& scene, const Settings& overrides);

/// The first over the second.
Settings joined(Settings first, const Settings& second);

/// The study's runs: on a failed one the check is not passed and says why under "trouble".
StudyResult go(const StudyTask& task, const std::filesystem::path& scene, const Settings& overrides,
               const StudyRuns::Listener& heard);

/// What a study has found, told to people: figures and their check on standard output; with a folder also a table and a
/// figure there.
void tell(const std::string& name, const StudyResult& result, const std::filesystem::path& out);

/// "stands", "stopped", or the mode of the first failure.
std::string outcome_word(const nlohmann::json& summary);

/// "key=value", the value as TOML reads it.
std::string setting(const std::string& key, double value);

struct StudyOptions {
  std::filesystem::path scene;
  std::string name;           ///< empty: all of the scene
  std::filesystem::path out;  ///< folder for figures and tables; empty: none, and runs/CASE-studies for [[study]]
  EngineOptions engine;
  Settings overrides;
};

/// blockweir study: returns 0 when every figure is within its tolerance and every [[study]] has found its own, else 1.
int perform_all(const StudyOptions& options);

}  // namespace blockweir::study
