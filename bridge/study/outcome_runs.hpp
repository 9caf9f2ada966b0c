// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of a study, side by side, whose outcomes are kept in a file: what is done is not done again.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/process/temporary_folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

struct OutcomePlan {
  std::string name;  ///< of the study
  std::filesystem::path scene;
  Settings set;                ///< holds in all runs
  Settings overrides;          ///< of the command line, over that
  std::filesystem::path kept;  ///< file of outcomes, a line each
  int jobs = 1;
  bool until_decided = false;  ///< a run that ends on the move is made longer
  bool of_factor = false;      ///< no runs: the factor of safety is asked for
};

/// What a run was set to and how it ended: settings, outcome, mode, joint, level_m, head_m, time_s, sliding_factor,
/// factor (of safety, where that is asked for), simulated_s, wall_time_s; trouble where it gave no answer. A figure
/// that it has not is null.
using Outcome = nlohmann::json;

class OutcomeRuns {
 public:
  explicit OutcomeRuns(OutcomePlan plan);

  /// An outcome for each setting, in their order. `later`: how many runs are likely to be asked for after these, for
  /// the time left. Throws Interrupted.
  std::vector<Outcome> make(const std::vector<Settings>& settings, std::size_t later = 0);

 private:
  [[nodiscard]] Settings whole(const Settings& settings) const;
  /// In a process of its own; into `file`.
  void make_one(const Settings& settings, const std::filesystem::path& file) const;
  void tell(const Outcome& outcome, std::size_t left);

  OutcomePlan plan_;
  std::map<std::string, Outcome> known_;  ///< by what decides them
  results::ResultFile kept_;
  process::TemporaryFolder scratch_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::size_t done_ = 0;  ///< of this call of the program
};

/// What decides the outcome of the scene with these settings: its digest, without its studies, and the version.
std::string outcome_key(const std::filesystem::path& scene, const Settings& all);

}  // namespace blockweir::study
