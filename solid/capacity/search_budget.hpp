// SPDX-License-Identifier: GPL-3.0-or-later
// Limits the time of a search by many static analyses, and prints its progress.
#pragma once

#include <chrono>
#include <climits>
#include <ctime>
#include <stdexcept>
#include <string>
#include <utility>

namespace blockweir::solid {

/// The time of the search is over: its answer is what is known by then.
struct TookTooLong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One analysis of the search exceeded its limit of linear systems.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class SearchBudget {
 public:
  /// `whose`: name of the search in lines of progress.
  explicit SearchBudget(std::string whose) : whose_(std::move(whose)) {}

  /// Sets what is known so far, for lines of progress.
  void knows(std::string text) { known_ = std::move(text); }
  [[nodiscard]] const std::string& known() const { return known_; }

  /// Starts the count of an analysis, which may solve this many linear systems.
  void allow(long systems) { last_allowed_ = solved_ > LONG_MAX - systems ? LONG_MAX : solved_ + systems; }
  /// Call after each solution of a linear system. Prints a line on standard error every other second. Throws
  /// TookTooLong, or Undecided if the analysis has solved more systems than it may.
  void solved_one();

 private:
  using Clock = std::chrono::steady_clock;

  std::string whose_;
  std::string known_ = "nothing known yet";
  long solved_ = 0;
  long last_allowed_ = LONG_MAX;
  std::clock_t began_ = std::clock();  ///< processor time, so that a busy machine does not change answers
  Clock::time_point told_ = Clock::now();
};

}  // namespace blockweir::solid
