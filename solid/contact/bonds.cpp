// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/bonds.hpp"

#include <algorithm>

namespace blockweir::solid {

bool break_bonds(const JointLaws& laws, std::span<const int> contact_ids, std::vector<ContactPoint>& contacts) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const auto breakable = [&](const ContactPoint& c) { return c.bond > 0 && !laws[c.law].keeps_cohesion; };
  const auto joint = [](const ContactPoint& c) { return std::minmax(c.vertex_block, c.edge_block); };
  const auto held = [&](const ContactPoint& slipping) {
    return std::any_of(contact_ids.begin(), contact_ids.end(), [&](int k) {
      const ContactPoint& c = contacts[at(k)];
      return c.state == ContactState::stick && breakable(c) && joint(c) == joint(slipping);
    });
  };
  const auto survives = [&](const ContactPoint& c) {
    if (c.state == ContactState::stick) return true;
    return c.state == ContactState::slip && (laws[c.law].softening_slip_m > 0 || held(c));
  };
  bool broken = false;
  for (const int k : contact_ids) {
    ContactPoint& c = contacts[at(k)];
    if (!breakable(c) || survives(c)) continue;
    c.bond = 0;
    broken = true;
  }
  return broken;
}

}  // namespace blockweir::solid
