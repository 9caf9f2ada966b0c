// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/interface_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::hydrostatic {

void add_panel(wire::Load& load, int block, int edge, double s_from, double s_to, double p_from, double p_to) {
  load.block.push_back(static_cast<std::uint32_t>(block));
  load.edge.push_back(static_cast<std::uint32_t>(edge));
  load.s_from.push_back(s_from);
  load.s_to.push_back(s_to);
  load.pressure_from_pa.push_back(p_from);
  load.pressure_to_pa.push_back(p_to);
}

void add_wet_elements(const std::vector<std::vector<Point>>& outlines, const std::vector<WetInterval>& wet,
                      const Hydrostatics& water, int elements_per_face, wire::Load& load) {
  const double n = elements_per_face;
  for (const WetInterval& w : wet) {
    const auto& outline = outlines[static_cast<std::size_t>(w.block)];
    const Point& a = outline[static_cast<std::size_t>(w.edge)];
    const Point span = outline[(static_cast<std::size_t>(w.edge) + 1) % outline.size()] - a;
    // A node on the surface may lie above it by round-off: its depth is zero then.
    const auto pressure = [&](double s) { return water.pressure(std::min(a.y() + s * span.y(), water.level_m)); };
    double s = w.s_from;
    for (auto k = static_cast<long>(std::floor(w.s_from * n)) + 1; s < w.s_to; ++k) {
      const double next = std::min(static_cast<double>(k) / n, w.s_to);
      if (next > s) add_panel(load, w.block, w.edge, s, next, pressure(s), pressure(next));
      s = std::max(s, next);
    }
  }
}

}  // namespace blockweir::hydrostatic
