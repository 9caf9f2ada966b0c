// SPDX-License-Identifier: GPL-3.0-or-later
// Random structures: how many, and from which seed. The environment's BLOCKWEIR_CAMPAIGN asks for more.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace blockweir::test {

/// So many of them in CI.
inline int campaign(int usual) {
  const char* more = std::getenv("BLOCKWEIR_CAMPAIGN");
  return more == nullptr ? usual : std::max(usual, std::atoi(more));
}

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  /// Evenly over orders of magnitude.
  double over_decades(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }

 private:
  std::mt19937 generator_;
};

}  // namespace blockweir::test
