// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the life of a scope to a sum of seconds.
#pragma once

#include <chrono>
#include <utility>

namespace blockweir {

class Stopwatch {
 public:
  explicit Stopwatch(double& sum_s) : sum_(sum_s), weight_(weight), start_(now()) {}
  ~Stopwatch() {
    if (weight_ > 0) sum_ += weight_ * std::chrono::duration<double>(now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

  /// A scope of which only some are timed, where a look at the clock takes as long as what it times: watches that start
  /// within count for `weight` such scopes, or, with a weight of 0, do not look.
  class Sample {
   public:
    explicit Sample(double of_scopes) : before_(std::exchange(weight, of_scopes)) {}
    ~Sample() { weight = before_; }
    Sample(const Sample&) = delete;
    Sample& operator=(const Sample&) = delete;

   private:
    double before_;
  };

  /// No watch of this process looks at the clock: what they cost can so be measured.
  static inline bool all_stopped = false;

 private:
  [[nodiscard]] std::chrono::steady_clock::time_point now() const {
    return all_stopped || weight_ == 0 ? std::chrono::steady_clock::time_point() : std::chrono::steady_clock::now();
  }
  static inline double weight = 1;
  double& sum_;
  double weight_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace blockweir
