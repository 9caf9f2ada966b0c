// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures along channels, and as panels on both faces of their joints.
#include <algorithm>
#include <utility>

#include "bridge/scene/at.hpp"
#include "bridge/wire/panels.hpp"
#include "fluid/joints/flow_in_joints.hpp"

namespace blockweir::joints {

bool FlowInJoints::flows_full(std::size_t channel) const {
  const Channel& c = joints_.network().channels[channel];
  const auto potential = [&](int node) {
    return filling_.pressure_pa[at(node)] + water_.weight_n_per_m3 * joints_.network().nodes[at(node)].height_m;
  };
  const int source = potential(c.from) >= potential(c.to) ? c.from : c.to;
  return filling_.saturation[at(source)] >= 1;
}

Profile FlowInJoints::profile(std::size_t channel) const {
  const Channel& c = joints_.network().channels[channel];
  const auto end = [&](int node) {
    return End{filling_.pressure_pa[at(node)], joints_.network().nodes[at(node)].height_m};
  };
  const End from = end(c.from);
  const End to = end(c.to);
  if (!flows_full(channel)) return standing(c.length_m, from, to, water_.weight_n_per_m3);
  return flowing(c.length_m, {c.aperture(0, from.pressure_pa), c.aperture(1, to.pressure_pa)}, from, to,
                 water_.weight_n_per_m3);
}

double FlowInJoints::pressure(std::size_t channel, double share) const {
  const Channel& c = joints_.network().channels[channel];
  if (!flows_full(channel)) return profile(channel).pressure(share * c.length_m);
  const double from = filling_.pressure_pa[at(c.from)];
  const double to = filling_.pressure_pa[at(c.to)];
  const double rise = joints_.network().nodes[at(c.to)].height_m - joints_.network().nodes[at(c.from)].height_m;
  const double left = fall_left({c.aperture(0, from), c.aperture(1, to)}, share);
  // In p + rho g y from the second node's, less the height of here.
  return std::max(
      0.0, to + (from - to - water_.weight_n_per_m3 * rise) * left + water_.weight_n_per_m3 * rise * (1 - share));
}

void FlowInJoints::add_panels(const OpenWater& open, wire::Load& load) const {
  for (std::size_t c = 0; c < joints_.parts().size(); ++c) {
    const Part& part = joints_.parts()[c];
    if (part.open) continue;
    const Profile along = profile(c);
    const double length_m = joints_.network().channels[c].length_m;
    for (const Side& side : joints_.stretches()[part.stretch].sides) {
      const auto place = [&](double at_m) {
        const double share = part.from + (part.to - part.from) * at_m / length_m;
        return std::clamp(side.s_from + share * (side.s_to - side.s_from), 0.0, 1.0);
      };
      if (open.covers(side.block, side.edge, place(length_m / 2))) continue;
      for (std::size_t k = 1; k < along.knots().size(); ++k) {
        const Profile::Knot& a = along.knots()[k - 1];
        const Profile::Knot& b = along.knots()[k];
        const int elements = scene_.water.elements_per_face;
        for (int e = 0; e < elements; ++e) {
          const auto at_m = [&](int i) { return a.at_m + (b.at_m - a.at_m) * i / elements; };
          const auto pressure = [&](int i) { return a.pressure_pa + (b.pressure_pa - a.pressure_pa) * i / elements; };
          double s_from = place(at_m(e));
          double s_to = place(at_m(e + 1));
          double p_from = pressure(e);
          double p_to = pressure(e + 1);
          if (s_from > s_to) std::swap(s_from, s_to), std::swap(p_from, p_to);
          if (p_from > 0 || p_to > 0) wire::add_panel(load, side.block, side.edge, s_from, s_to, p_from, p_to);
        }
      }
    }
  }
}

}  // namespace blockweir::joints
