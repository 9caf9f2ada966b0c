// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/crest_water.hpp"

#include <algorithm>

namespace blockweir::hydrostatic {

double Surface::at(double x) const {
  const double width = to_m.x() - from_m.x();
  const double share = width > 0 ? std::clamp((x - from_m.x()) / width, 0.0, 1.0) : 0;
  return from_m.y() + share * (to_m.y() - from_m.y());
}

Surface over_the_crest(const Structure& structure, double upstream_m, double downstream_m, scene::CrestPressure law) {
  if (law == scene::CrestPressure::none || downstream_m > upstream_m) {
    return Surface::level(std::min(upstream_m, downstream_m));
  }
  if (law == scene::CrestPressure::full) return Surface::level(upstream_m);
  return {{crest_corner(structure, Pool::upstream).x(), upstream_m},
          {crest_corner(structure, Pool::downstream).x(), downstream_m}};
}

std::vector<WetInterval> without(const std::vector<WetInterval>& all,
                                 const std::vector<const std::vector<WetInterval>*>& parts) {
  constexpr double none = 1e-9;  // of an edge: both searches round
  std::vector<WetInterval> rest;
  for (const WetInterval& one : all) {
    std::vector<std::pair<double, double>> taken;
    for (const auto* part : parts) {
      for (const WetInterval& w : *part) {
        if (w.block == one.block && w.edge == one.edge) taken.emplace_back(w.s_from, w.s_to);
      }
    }
    std::sort(taken.begin(), taken.end());
    taken.emplace_back(one.s_to, one.s_to);
    double from = one.s_from;
    for (const auto& [low, high] : taken) {
      const double to = std::min(low, one.s_to);
      if (to - from > none) rest.push_back({one.block, one.edge, from, to});
      from = std::max(from, high);
    }
  }
  return rest;
}

}  // namespace blockweir::hydrostatic
