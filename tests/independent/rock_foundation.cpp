// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/rock_foundation.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::independent {
namespace {

/// Rock and dam as one, which turn over the end of the bedding and leave the wall behind the rock. Limit analysis lets
/// that wall's friction hold them: its slip dilates, and one that turns up along the wall would be pressed to it.
double turning_level_on_rock(const Structure& s, double high_m) {
  const auto& rock = s.bodies[1].outline_m;
  const auto& dam = s.bodies[2].outline_m;
  Stack both{"bedding", dam[0], rock[1], dam[3], dam[2]};
  const std::vector<Wrench> weights = weights_of(s);
  both.weight_n_per_m = -(weights[1] + weights[2]).y();
  both.centroid_m.x() = -(weights[1] + weights[2]).z() / both.weight_n_per_m;
  return overturning_level(both, high_m);
}

}  // namespace

std::optional<Failing> failing_on_rock(const Structure& s, const Limit& limit, double high_m) {
  const auto& dam = s.bodies[2].outline_m;
  const Stack stack = stack_of("contact", dam[0], dam[1], dam[3], dam[2], s.joints[0].law, s.density_kg_per_m3, none_m);
  const double alone_m = first_failure({stack}, high_m).level_m;
  const double turns_m = turning_level_on_rock(s, high_m);
  if (turns_m < limit.level_m) return Failing{turns_m, "overturning", "bedding", turns_m, limit.level_m};
  if (limit.velocities.empty()) return std::nullopt;
  const Eigen::Vector3d& rock = limit.velocities[1];
  const bool slides = rock.head<2>().norm() > 1e-3 && std::abs(rock[2]) < 1e-6 * rock.head<2>().norm();
  if (!slides) return std::nullopt;
  return Failing{limit.level_m, "sliding", "bedding", limit.level_m, std::min(alone_m, turns_m)};
}

}  // namespace blockweir::independent
