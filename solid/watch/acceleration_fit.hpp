// SPDX-License-Identifier: GPL-3.0-or-later
// Acceleration of the centroids over a run by least squares, in which oscillations about the motion cancel out.
#pragma once

#include <array>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Fits u(t) = a + b t + c t^2 to each block's displacement relative to the base.
class AccelerationFit {
 public:
  void add(double time_s, const std::vector<BlockState>& states, const Point& base_displacement = Point::Zero());
  /// 2 |c| [m/s2]; not a number with fewer than three times.
  [[nodiscard]] double of(std::size_t block) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(time_powers_, moments_);
  }

 private:
  std::array<double, 5> time_powers_{};               ///< sums of t^0 to t^4
  std::vector<Eigen::Matrix<double, 3, 2>> moments_;  ///< sums of t^k u, k = 0 to 2, for each block
};

}  // namespace blockweir::solid
