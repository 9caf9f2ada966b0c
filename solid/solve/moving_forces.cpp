// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/moving_forces.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace blockweir::solid {

double MovingForces::find(const Eigen::VectorXd& loads, double enough_m) {
  constexpr int most_solutions = 60;
  constexpr int patience = 20;    // solutions that come no nearer
  constexpr double stuck = 0.01;  // of a correction
  forces_.begin(loads);
  if (loads.isZero(0)) return 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  std::vector<ConeForces::Pairs> nearest;
  int at = 0;
  while (true) {
    const double left_m = forces_.off_laws_m();
    if (left_m < nearest_m) {
      nearest_m = left_m;
      nearest = forces_.pairs();
      at = forces_.solutions();
    }
    if (nearest_m <= enough_m || forces_.solutions() >= std::min(most_solutions, at + patience)) break;
    if (forces_.fraction() < stuck) break;
    forces_.let_slip(smooth_m(enough_m));
    if (!forces_.improve()) break;
  }
  forces_.pairs() = std::move(nearest);
  return nearest_m;
}

/// What the products still are of the normal forces; a part of what is enough remains.
double MovingForces::smooth_m(double enough_m) const {
  constexpr double remains = 0.2;
  double normal = 0;
  for (const auto& [minus, plus] : forces_.pairs()) normal += minus.force + plus.force;
  return remains * enough_m + forces_.mean_product() * static_cast<double>(forces_.pairs().size()) / normal;
}

}  // namespace blockweir::solid
