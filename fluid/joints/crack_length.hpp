// SPDX-License-Identifier: GPL-3.0-or-later
// The open length of a joint by the gravity method without tension: the effective pressure on the closed part is
// linear, and zero at the crack tip. N is the force on the joint without its water, acting at distance r from the
// closed end; U is the water's force, M_U its moment about that end, and b the closed length:
//   N r - M_U = (N - U) b/3.
// This is solved for b together with the uplift, which depends on b. (With water of pressure p at the open end and none
// at the other, b = 3 (N r - p L^2/2)/(N - p L).)
#pragma once

#include <vector>

#include "bridge/scene/cracks.hpp"
#include "bridge/statics/wrench.hpp"
#include "fluid/joints/uplift.hpp"

namespace blockweir::joints {

/// Normal force on a joint [N/m], and its moments about the joint's ends [N], positive if it acts between them.
struct Thrust {
  double normal_n_per_m = 0;
  double about_mouth_n = 0;
  double about_end_n = 0;
};

/// The part of the structure on a joint that separates it from the ground.
class Parted {
 public:
  Parted(const scene::Scene& scene, const scene::Crack& crack);
  /// The thrust from wrenches about the blocks' centroids as drawn. Forces between two of these blocks must
  /// cancel.
  [[nodiscard]] Thrust thrust(const statics::Wrenches& loads) const;

 private:
  std::vector<int> blocks_;
  std::vector<statics::Point> centroids_;
  statics::Point mouth_;
  statics::Point end_;
};

/// The joint with open_at_mouth_m and open_at_end_m determined: the whole length if no closed part can balance the
/// thrust. `law` and `known` give the uplift.
Joint opened(scene::Uplift law, const scene::KnownHeads& known, Joint joint, const Thrust& thrust);

}  // namespace blockweir::joints
