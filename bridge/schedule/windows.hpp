// SPDX-License-Identifier: GPL-3.0-or-later
// When solid and fluid exchange. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace blockweir::schedule {

/// Coupling windows: window n ends at n * window_s, the last one at the run's duration. With `at_rest` all of them end
/// at the run's end.
class Windows {
 public:
  Windows(double window_s, double duration_s, bool at_rest)
      : window_s_(window_s),
        duration_s_(duration_s),
        at_rest_(at_rest),
        count_(at_rest ? most_sweeps
                       : static_cast<std::uint64_t>(std::max(1.0, std::ceil(duration_s / window_s * (1 - 1e-12))))) {}
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double end_s(std::uint64_t window) const {
    return at_rest_ || window >= count_ ? duration_s_ : static_cast<double>(window) * window_s_;
  }

 private:
  static constexpr std::uint64_t most_sweeps = 1000;
  double window_s_;
  double duration_s_;
  bool at_rest_;
  std::uint64_t count_;
};

}  // namespace blockweir::schedule
