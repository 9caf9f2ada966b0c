// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/acceleration_fit.hpp"

#include <Eigen/LU>
#include <limits>

namespace blockweir::solid {

void AccelerationFit::add(double time_s, const std::vector<BlockState>& states, const Point& base_displacement) {
  double power = 1;
  for (double& sum : time_powers_) sum += power, power *= time_s;
  const Eigen::Vector3d powers(1, time_s, time_s * time_s);
  moments_.resize(states.size(), Eigen::Matrix<double, 3, 2>::Zero());
  for (std::size_t b = 0; b < states.size(); ++b) {
    moments_[b] += powers * (states[b].displacement.head<2>() - base_displacement).transpose();
  }
}

double AccelerationFit::of(std::size_t block) const {
  if (time_powers_[0] < 3) return std::numeric_limits<double>::quiet_NaN();
  Eigen::Matrix3d normal;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) normal(i, j) = time_powers_[static_cast<std::size_t>(i + j)];
  }
  const Eigen::Matrix<double, 3, 2> coefficients = normal.fullPivLu().solve(moments_[block]);
  return 2 * coefficients.row(2).norm();
}

}  // namespace blockweir::solid
