// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers drawn at random.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace blockweir::independent {

/// Numbers that are the same everywhere for the same seed and purpose (splitmix64).
class Random {
 public:
  Random(std::uint64_t seed, const std::string& purpose);
  std::uint64_t next();
  double between(double low, double high);
  double between_orders(double low, double high);  ///< uniform in the logarithm
  std::size_t below(std::size_t count);
  bool chance(double probability);
  template <class T>
  const T& of(const std::vector<T>& all) {
    return all[below(all.size())];
  }

 private:
  std::uint64_t state_;
};

}  // namespace blockweir::independent
