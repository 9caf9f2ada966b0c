// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/lagged_friction.hpp"

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

void LaggedFriction::begin(const Held& held) {
  bounds.begin(held.contacts.size());
  for (const int k : held.contact_ids) bounds.set(k, shear_bound(held.contacts[at(k)]));
}

bool LaggedFriction::follow(const Held& held, const StepProgress& progress, double tolerance_n) {
  return bounds.follow(
      held.contact_ids, [&](int k) { return shear_bound(held.contacts[at(k)]); },
      [&](int k) { return tolerance_n + progress.contact(k).round_off; });
}

double LaggedFriction::shear_bound(const ContactPoint& c) const {
  return laws_.strength(c, c.force.x()).shear_bound(c.force.x());
}

}  // namespace blockweir::solid
