// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/standing_forces.hpp"

#include <cmath>

namespace blockweir::solid {

bool StandingForces::found(const Eigen::VectorXd& loads, double enough_m) {
  constexpr int most_solutions = 60;
  constexpr double balanced = 1e-8;  // of the largest load
  constexpr double surely = 1e4;     // where forces are next to the edge of their cones products are as much less
  constexpr double exactly = 1e-3;   // of what is enough, where it costs only a solution or two
  forces_.begin(loads);
  while (forces_.solutions() < most_solutions) {
    const bool balances = forces_.unbalanced() <= balanced;
    if (balances && stands(exactly * enough_m)) return true;
    // What is lost in slip is known to the sum of all products. Round-off spoils the balance of what slips.
    const double known = lost_in_slip() / (forces_.mean_product() * static_cast<double>(2 * forces_.pairs().size()));
    if (known > surely && !stands(enough_m)) return false;
    if (known > surely && balances) return true;
    if (!forces_.improve()) return false;
  }
  return false;
}

/// What bears next to nothing may slip, as what is open does, and what has no friction.
bool StandingForces::stands(double enough_m) const {
  constexpr double nothing = 1e-6;
  for (std::size_t row = 0; row < forces_.pairs().size(); ++row) {
    const auto& [minus, plus] = forces_.pairs()[row];
    const bool slips = std::abs(plus.motion - minus.motion) > 2 * enough_m * forces_.friction(row);
    if (slips && minus.force + plus.force > nothing * forces_.largest_load()) return false;
  }
  return true;
}

double StandingForces::lost_in_slip() const {
  double lost = 0;
  for (const auto& [minus, plus] : forces_.pairs()) {
    lost += (minus.force + plus.force) * std::abs(plus.motion - minus.motion) / 2;
  }
  return lost;
}

}  // namespace blockweir::solid
