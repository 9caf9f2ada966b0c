// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/margins.hpp"

#include <algorithm>
#include <cmath>

#include "solid/watch/surface_sum.hpp"

namespace blockweir::solid {
namespace {

/// Does a bolt that pulls cross the surface's line?
bool is_anchored(const Solid& solid, const SurfaceSum& sum) {
  const auto side = [&](const Point& p) { return sum.across().dot(p - sum.upstream_end()); };
  return std::any_of(solid.bolts().begin(), solid.bolts().end(), [&](const Bolt& bolt) {
    return bolt.acting.tension_n_per_m > 0 && side(bolt.described->from_m) * side(bolt.described->to_m) < 0;
  });
}

std::string holder(const Solid& solid, const SurfaceSum& sum) {
  if (!sum.ends_at_nothing()) return {};
  const bool anchored = is_anchored(solid, sum);
  if (!sum.is_pulled()) return anchored ? "an anchor" : "";
  return anchored ? "tension strength and an anchor" : "tension strength";
}

}  // namespace

void Margins::look(const Solid& solid, double time_s, const Levels& levels) {
  const double level_m = levels.higher_m();
  if (!surfaces_) surfaces_.emplace(solid);
  const std::vector<SurfaceSum> sums = surface_sums(solid, *surfaces_);
  // While the ground shakes, water has no time to fill a crack.
  if (!solid.scene().base_motion) opened_.look(*surfaces_, sums, levels);
  sliding_now_.reset();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!sums[i].bears(surfaces_->weights()[i])) continue;
    const auto keep_lowest = [&](std::optional<Margin>& lowest, double value) {
      if (lowest && lowest->value <= value) return false;
      lowest = Margin{value, time_s, level_m, surfaces_->names()[i], {}, {}};
      return true;
    };
    if (sums[i].is_sheared()) {
      if (sums[i].is_buttressed()) {
        buttressed_ = true;
      } else {
        keep_lowest(sliding_, sums[i].sliding_factor());
        keep_lowest(sliding_now_, sums[i].sliding_factor());
      }
    }
    if (sums[i].is_pressed() && keep_lowest(overturning_, sums[i].end_distance())) {
      overturning_->end = sums[i].nearer_end(!std::isnan(level_m));
      overturning_->held_by = holder(solid, sums[i]);
    }
  }
}

}  // namespace blockweir::solid
