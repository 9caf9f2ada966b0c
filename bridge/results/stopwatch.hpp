// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the life of a scope to a sum of seconds.
#pragma once

#include <chrono>

namespace blockweir {

class Stopwatch {
 public:
  explicit Stopwatch(double& sum_s) : sum_(sum_s), start_(std::chrono::steady_clock::now()) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace blockweir
