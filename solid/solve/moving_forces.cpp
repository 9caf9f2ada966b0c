// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/moving_forces.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace blockweir::solid {
namespace {

/// Of what is enough, while it costs only a solution or two: what is off adds up over the joints of a column.
constexpr double exactly = 1e-3;

}  // namespace

double MovingForces::find(const Eigen::VectorXd& loads, double enough_m) {
  constexpr int most_solutions = 60;
  constexpr int patience = 20;      // solutions that do not halve what is off
  constexpr int patience_near = 8;  // where it is enough
  constexpr double stuck = 0.01;    // of a correction
  forces_.begin(loads);
  if (loads.isZero(0)) return 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  double halved_m = nearest_m;
  std::vector<ConeForces::Pairs> nearest;
  int at = 0;
  while (true) {
    const double left_m = forces_.off_laws_m();
    if (left_m < nearest_m) {
      nearest_m = left_m;
      nearest = forces_.pairs();
    }
    if (left_m < halved_m / 2) {
      halved_m = left_m;
      at = forces_.solutions();
    }
    if (nearest_m <= exactly * enough_m || forces_.fraction() < stuck) break;
    const int patient = nearest_m <= enough_m ? patience_near : patience;
    if (forces_.solutions() >= std::min(most_solutions, at + patient)) break;
    forces_.let_slip(smooth_m(exactly * enough_m));
    if (!forces_.improve()) break;
  }
  forces_.pairs() = std::move(nearest);
  return nearest_m;
}

/// What the products still are of the normal forces; a part of what is left in the end remains.
double MovingForces::smooth_m(double left_m) const {
  constexpr double remains = 0.2;
  double normal = 0;
  for (const auto& [minus, plus] : forces_.pairs()) normal += minus.force + plus.force;
  return remains * left_m + forces_.mean_product() * static_cast<double>(forces_.pairs().size()) / normal;
}

}  // namespace blockweir::solid
