// SPDX-License-Identifier: GPL-3.0-or-later
// Friction whose bounds lag behind the normal forces of contacts.
#pragma once

#include "solid/contact/island_contacts.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/contact/lagged_bounds.hpp"
#include "solid/contact/step_progress.hpp"

namespace blockweir::solid {

class LaggedFriction {
 public:
  /// The laws must outlive it.
  explicit LaggedFriction(const JointLaws& laws) : laws_(laws) {}

  LaggedBounds bounds;

  /// Bounds of shear by the normal forces of now, until the next call of this or the following.
  void begin(const IslandContacts& island);
  /// Bounds of shear nearer to what the normal forces of now allow: true when they were there, but for `tolerance_n` [N
  /// per metre] and round-off.
  bool follow(const IslandContacts& island, const StepProgress& progress, double tolerance_n);

 private:
  [[nodiscard]] double shear_bound(const ContactPoint& c) const;

  const JointLaws& laws_;
};

}  // namespace blockweir::solid
