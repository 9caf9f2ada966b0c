// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets of numbers (union-find): pairs are joined, and each set has one representative.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace blockweir::joints {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), 0); }
  std::size_t of(std::size_t i) {
    while (of_[i] != i) i = of_[i] = of_[of_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    of_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> of_;
};

}  // namespace blockweir::joints
