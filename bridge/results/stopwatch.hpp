// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the life of a scope to a sum of seconds.
#pragma once

#include <chrono>

namespace blockweir {

class Stopwatch {
 public:
  explicit Stopwatch(double& sum_s) : sum_(sum_s), start_(now()) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

  /// No watch of this process looks at the clock: what they cost can so be measured.
  static inline bool all_stopped = false;

 private:
  static std::chrono::steady_clock::time_point now() {
    return all_stopped ? std::chrono::steady_clock::time_point() : std::chrono::steady_clock::now();
  }
  double& sum_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace blockweir
