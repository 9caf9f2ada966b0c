// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel runs of a study. Outcomes are stored in a file, so that no run is repeated.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/engine/engine.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/study/outcome_work.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

struct OutcomePlan {
  std::string name;  ///< of the study
  std::filesystem::path scene;
  Settings set;                ///< in all runs
  Settings overrides;          ///< of the command line; they replace `set`
  std::filesystem::path kept;  ///< file of outcomes, one line each
  std::string by = "run";      ///< see study_worker()
  bool until_decided = false;  ///< a run that ends in motion is continued longer
  bool of_many = false;        ///< progress shows the number of finished runs, not each outcome
};

class OutcomeRuns {
 public:
  /// The engine must outlive the object.
  OutcomeRuns(OutcomePlan plan, engine::Engine& engine);

  /// Outcomes of the settings, in their order. `later`: number of further runs likely to follow, to estimate the
  /// remaining time. `brief`: not worth a queue. Throws Interrupted.
  std::vector<Outcome> make(const std::vector<Settings>& settings, std::size_t later = 0, bool brief = false);

  /// Number of runs in this call of the program.
  [[nodiscard]] std::size_t made() const { return done_; }

 private:
  /// A text of all that decides an outcome: the scene with overrides, without its studies; the settings, the method,
  /// the version.
  [[nodiscard]] std::string key_of(const Settings& settings) const;
  void report_progress(const Outcome& outcome, std::size_t left);

  OutcomePlan plan_;
  engine::Engine& engine_;
  std::string base_;
  std::map<std::string, Outcome> known_;  ///< by key_of()
  results::ResultFile kept_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point reported_ = std::chrono::steady_clock::now();
  std::size_t done_ = 0;  ///< in this call of the program
};

}  // namespace blockweir::study
