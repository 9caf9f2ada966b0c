// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/bonds.hpp"

#include <algorithm>

#include "solid/block/parallel.hpp"

namespace blockweir::solid {

bool break_bonds(const JointLaws& laws, std::span<const int> contact_ids, std::vector<ContactPoint>& contacts) {
  const auto at = [&](int k) -> ContactPoint& { return contacts[static_cast<std::size_t>(k)]; };
  const auto breakable = [&](const ContactPoint& c) { return c.bond > 0 && !laws[c.law].keeps_cohesion; };
  const auto stays = [&](std::size_t i) {
    const ContactPoint& c = at(contact_ids[i]);
    return c.state == ContactState::stick || !breakable(c);
  };
  if (all_of(contact_ids.size(), stays)) return false;
  bool broken = false;
  for (auto first = contact_ids.begin(), end = first; first != contact_ids.end(); first = end) {
    end = std::find_if(first, contact_ids.end(), [&](int k) { return at(k).pair() != at(*first).pair(); });
    const bool held =
        std::any_of(first, end, [&](int k) { return at(k).state == ContactState::stick && breakable(at(k)); });
    const auto survives = [&](const ContactPoint& c) {
      if (c.state == ContactState::stick) return true;
      return c.state == ContactState::slip && (laws[c.law].softening_slip_m > 0 || held);
    };
    for (auto k = first; k != end; ++k) {
      if (!breakable(at(*k)) || survives(at(*k))) continue;
      at(*k).bond = 0;
      broken = true;
    }
  }
  return broken;
}

}  // namespace blockweir::solid
