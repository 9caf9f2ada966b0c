// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of a study, side by side, whose outcomes are kept in a file: what is done is not done again.
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
  Settings set;                ///< holds in all runs
  Settings overrides;          ///< of the command line, over that
  std::filesystem::path kept;  ///< file of outcomes, a line each
  std::string by = "run";      ///< see study_worker()
  bool until_decided = false;  ///< a run that ends on the move is made longer
  bool of_many = false;        ///< what is told is how many are done, not how each has ended
};

class OutcomeRuns {
 public:
  /// The engine has to outlive it.
  OutcomeRuns(OutcomePlan plan, engine::Engine& engine);

  /// An outcome for each setting, in their order. `later`: how many runs are likely to be asked for after these, for
  /// the time left. `brief`: not worth a queue. Throws Interrupted.
  std::vector<Outcome> make(const std::vector<Settings>& settings, std::size_t later = 0, bool brief = false);

  /// Of this call of the program.
  [[nodiscard]] std::size_t made() const { return done_; }

 private:
  /// What decides an outcome: the scene as the command line has it, without its studies; the settings, the way, the
  /// version.
  [[nodiscard]] std::string key_of(const Settings& settings) const;
  void tell(const Outcome& outcome, std::size_t left);

  OutcomePlan plan_;
  engine::Engine& engine_;
  std::string base_;
  std::map<std::string, Outcome> known_;  ///< by what decides them
  results::ResultFile kept_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
  std::size_t done_ = 0;  ///< of this call of the program
};

}  // namespace blockweir::study
