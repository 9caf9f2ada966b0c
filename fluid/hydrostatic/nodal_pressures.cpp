// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/nodal_pressures.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/wire/panels.hpp"

namespace blockweir::hydrostatic {

void add_wet_elements(const std::vector<std::vector<Point>>& outlines, const std::vector<WetInterval>& wet,
                      const scene::Scene& scene, const Surface& surface, int elements_per_face, wire::Load& load) {
  const double n = elements_per_face;
  for (const WetInterval& w : wet) {
    const auto& outline = outlines[static_cast<std::size_t>(w.block)];
    const Point& a = outline[static_cast<std::size_t>(w.edge)];
    const Point span = outline[(static_cast<std::size_t>(w.edge) + 1) % outline.size()] - a;
    // A node on the surface may lie above it by round-off: its depth is zero then.
    const auto pressure = [&](double s) {
      const scene::Hydrostatics water = scene::on_wet_faces(scene, surface.at(a.x() + s * span.x()));
      return water.pressure(std::min(a.y() + s * span.y(), water.level_m));
    };
    double s = w.s_from;
    for (auto k = static_cast<long>(std::floor(w.s_from * n)) + 1; s < w.s_to; ++k) {
      const double next = std::min(static_cast<double>(k) / n, w.s_to);
      if (next > s) wire::add_panel(load, w.block, w.edge, s, next, pressure(s), pressure(next));
      s = std::max(s, next);
    }
  }
}

}  // namespace blockweir::hydrostatic
