// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds the time of a search by many static analyses, and tells how it gets on.
#pragma once

#include <chrono>
#include <climits>
#include <ctime>
#include <stdexcept>
#include <string>
#include <utility>

namespace blockweir::solid {

/// The time of a search is over: what it knows by then is its answer.
struct TookTooLong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One analysis of a search took more than it is to.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class SearchBudget {
 public:
  /// `whose`: how lines of progress call the search.
  explicit SearchBudget(std::string whose) : whose_(std::move(whose)) {}

  /// What is known so far, for lines of progress.
  void knows(std::string text) { known_ = std::move(text); }
  /// For the analysis that begins: how many linear systems it may solve.
  void allow(long systems) { last_allowed_ = solved_ > LONG_MAX - systems ? LONG_MAX : solved_ + systems; }
  /// To be called after each solution of a linear system: a line on standard error every other second. Throws
  /// TookTooLong, and Undecided where an analysis solves more systems than it may.
  void solved_one();

 private:
  using Clock = std::chrono::steady_clock;

  std::string whose_;
  std::string known_ = "nothing known yet";
  long solved_ = 0;
  long last_allowed_ = LONG_MAX;
  std::clock_t began_ = std::clock();  ///< processor time: a busy machine changes no answer
  Clock::time_point told_ = Clock::now();
};

}  // namespace blockweir::solid
