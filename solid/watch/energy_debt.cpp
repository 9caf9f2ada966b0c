// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/energy_debt.hpp"

#include "bridge/scene/at.hpp"
#include "solid/solve/islands.hpp"

namespace blockweir::solid {

std::vector<bool> in_debt(const Solid& solid) {
  const auto& blocks = solid.blocks();
  const double rest = solid.scene().analysis.rest_speed_m_per_s;
  std::vector<bool> marked(blocks.size());
  bool any = false;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    marked[b] = solid.state().energy.owed(b) > 0;
    any = any || marked[b];
  }
  if (any) {
    std::vector<bool> fixed(blocks.size());
    for (std::size_t b = 0; b < blocks.size(); ++b) fixed[b] = blocks[b].fixed;
    std::vector<std::pair<int, int>> links;
    for (const ContactPoint& c : solid.contacts()) {
      if (c.state == ContactState::open) continue;
      links.emplace_back(c.vertex_part, c.edge_part);
    }
    const auto& triangles = solid.parts().triangles;
    for (std::size_t b = 0; b < triangles.size(); ++b) {
      for (const int t : triangles[b]) links.emplace_back(static_cast<int>(b), t);
    }
    for (const Island& group : find_islands(fixed, links, {})) {
      double owed = 0;
      double mass = 0;
      for (const int b : group.blocks) {
        owed += solid.state().energy.owed(at(b));
        if (!blocks[at(b)].meshed) mass += blocks[at(b)].mass_per_m();
      }
      for (const int b : group.blocks) marked[at(b)] = owed > mass * rest * rest / 2;
    }
  }
  marked.resize(solid.described());
  return marked;
}

}  // namespace blockweir::solid
