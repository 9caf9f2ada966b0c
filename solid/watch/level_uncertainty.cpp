// SPDX-License-Identifier: GPL-3.0-or-later
// How well a failure's level is known, from the motion before and after it began.
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {
namespace {

/// Rotation about a toe requires moments: a column of height h and breadth b, whose middle is accelerated by a, resists
/// with m a (2/3) (h^2 + b^2)/h, and a rise dh of the level gives rho g head dh head/2.
double turning_lever(const Solid& solid, const Failure& failure) {
  Eigen::AlignedBox2d box;
  for (const int b : failure.blocks) {
    for (const Point& X : solid.blocks()[at(b)].vertices) box.extend(solid.placements()[at(b)].position(X));
  }
  const double lever = 4.0 / 3 * box.sizes().squaredNorm() / (box.sizes().y() * failure.head_m);
  return std::max(1.0, lever);
}

}  // namespace

void FailureWatch::add_uncertainty(const Watched& last, Failure& failure) const {
  const scene::Scene& scene = solid_.scene();
  // On the improved schedule the level that acts is that of the window's middle.
  const double windows = scene.coupling.schedule == scene::Schedule::improved ? 1.5 : 1;
  if (last.next_s > 0) {
    failure.window_rise_m = windows * std::abs(last.next.of(failure.downstream) - last.levels.of(failure.downstream));
  }
  // A force that grows linearly with time moves a body by a t^3/6 and brings it to the speed v that shows after sqrt(2
  // v/a); rotation starts more slowly than that.
  const double passed_s = solid_.time_s() - last.time_s;
  const double growth = 6 * failure.travel_m / std::pow(passed_s, 3);
  const double seen_m_per_s = std::max(scene.analysis.rest_speed_m_per_s, last.crept);
  const double unseen_s = std::min(passed_s, 2 * std::sqrt(2 * seen_m_per_s / growth));
  const double rate = last.next_s > last.time_s ? failure.window_rise_m / (last.next_s - last.time_s) : 0;
  // Effect of inertia when the body was last at rest, as a rise of the level: rho g head dh.
  Point inertia = Point::Zero();
  for (const int k : failure.blocks) inertia += solid_.blocks()[at(k)].mass_per_m() * watched_[at(k)].acceleration;
  const double per_m = scene::unit_weight_of_water(scene) * failure.head_m;
  const bool turns = failure.mode.find("overturning") != std::string::npos;
  const double lever = turns ? turning_lever(solid_, failure) : 1;
  const double held_back_m = per_m > 0 ? lever * inertia.norm() / per_m : 0;
  const double stuck_m = std::abs(last.last.of(failure.downstream) - last.levels.of(failure.downstream));
  failure.level_uncertainty_m = failure.window_rise_m + rate * unseen_s + std::max(stuck_m, held_back_m);
}

}  // namespace blockweir::solid
