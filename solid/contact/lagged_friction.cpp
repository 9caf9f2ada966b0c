// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/lagged_friction.hpp"

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

void LaggedFriction::begin(const IslandContacts& island) {
  bounds.begin(island.contacts.size());
  for (const int k : island.contact_ids) bounds.set(k, shear_bound(island.contacts[at(k)]));
}

bool LaggedFriction::follow(const IslandContacts& island, const StepProgress& progress, double tolerance_n) {
  return bounds.follow(
      island.contact_ids, [&](int k) { return shear_bound(island.contacts[at(k)]); },
      [&](int k) { return tolerance_n + progress.contact(k).round_off; });
}

double LaggedFriction::shear_bound(const ContactPoint& c) const {
  return laws_.strength(c, c.force.x()).shear_bound(c.force.x());
}

}  // namespace blockweir::solid
