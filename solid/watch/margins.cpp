// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/margins.hpp"

#include <cmath>

#include "solid/watch/surface_sum.hpp"

namespace blockweir::solid {

void Margins::look(const Solid& solid, double time_s, double level_m) {
  if (!surfaces_) surfaces_.emplace(solid);
  const std::vector<SurfaceSum> sums = surface_sums(solid, *surfaces_);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!sums[i].bears(surfaces_->weights()[i])) continue;
    const auto keep_lowest = [&](std::optional<Margin>& lowest, double value, const char* end = "") {
      if (lowest && lowest->value <= value) return;
      lowest = Margin{value, time_s, level_m, surfaces_->names()[i], end};
    };
    if (sums[i].is_sheared()) {
      if (sums[i].is_buttressed()) {
        buttressed_ = true;
      } else {
        keep_lowest(sliding_, sums[i].sliding_factor());
      }
    }
    if (sums[i].is_pressed()) {
      keep_lowest(overturning_, sums[i].end_distance(), sums[i].nearer_end(!std::isnan(level_m)));
    }
  }
}

}  // namespace blockweir::solid
