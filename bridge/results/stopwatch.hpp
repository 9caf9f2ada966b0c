// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the duration of a scope to a sum of seconds.
#pragma once

#include <chrono>
#include <utility>

#include "bridge/results/seconds.hpp"

namespace blockweir {

class Stopwatch {
 public:
  explicit Stopwatch(double& sum_s) : sum_(sum_s), weight_(weight), start_(now()) {}
  ~Stopwatch() {
    if (weight_ > 0) sum_ += weight_ * seconds_between(start_, now());
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

  /// Times only some repetitions of a short scope, because reading the clock takes as long as the scope. Stopwatches
  /// started within count for `weight` repetitions, or, with weight 0, do not read the clock.
  class Sample {
   public:
    explicit Sample(double of_scopes) : before_(std::exchange(weight, of_scopes)) {}
    ~Sample() { weight = before_; }
    Sample(const Sample&) = delete;
    Sample& operator=(const Sample&) = delete;

   private:
    double before_;
  };

  /// No stopwatch of this process reads the clock; readings are counted instead, to estimate their cost.
  static inline bool all_stopped = false;
  static inline long looks_not_taken = 0;

 private:
  [[nodiscard]] std::chrono::steady_clock::time_point now() const {
    if (weight_ == 0) return {};
    if (!all_stopped) return std::chrono::steady_clock::now();
    ++looks_not_taken;
    return {};
  }
  static inline double weight = 1;
  double& sum_;
  double weight_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace blockweir
