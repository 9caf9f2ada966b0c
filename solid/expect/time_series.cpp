// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/expect/time_series.hpp"

#include "solid/expect/quantity_tables.hpp"

namespace blockweir::solid::expect {

TimeSeries::TimeSeries(const Solid& solid) {
  for (const scene::Expectation& e : solid.scene().expectations) {
    if (series_quantities().contains(e.quantity)) courses_[block_index(solid, e.of)];
  }
}

void TimeSeries::look(const Solid& solid, const std::vector<Panel>& water, double time_s) {
  for (auto& [block, course] : courses_) {
    Point force = Point::Zero();
    for (const Panel& panel : water) {
      if (static_cast<std::size_t>(panel.block) != block) continue;
      const PanelForce f =
          panel_force(solid.blocks()[block], solid.placements()[block], panel, solid.scene().water.nodal_rule);
      force += f.force[0] + f.force[1];
    }
    course.push_back({time_s, solid.states()[block].displacement, solid.states()[block].velocity, force});
  }
}

const Course& TimeSeries::of(std::size_t block) const {
  static const Course none;
  const auto found = courses_.find(block);
  return found == courses_.end() ? none : found->second;
}

}  // namespace blockweir::solid::expect
