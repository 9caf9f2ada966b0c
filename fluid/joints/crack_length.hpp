// SPDX-License-Identifier: GPL-3.0-or-later
// How far a joint is open, by the gravity method without tension: the effective pressure on what is closed is linear,
// and zero at the tip of the crack. With N the force on the joint of all but its water, acting at r from the closed
// end, U the water's force, M_U its moment about that end, and b what is closed,
//   N r - M_U = (N - U) b/3,
// which is solved for b together with the uplift that depends on it. (With water of pressure p at the open end and none
// at the other this is b = 3 (N r - p L^2/2)/(N - p L).)
#pragma once

#include <vector>

#include "bridge/scene/cracks.hpp"
#include "bridge/statics/wrench.hpp"
#include "fluid/joints/uplift.hpp"

namespace blockweir::joints {

/// Normal force on a joint [N/m], and its moments about the joint's ends, positive where it presses between them [N].
struct Thrust {
  double normal_n_per_m = 0;
  double about_mouth_n = 0;
  double about_end_n = 0;
};

/// What stands on a joint that parts it from the ground.
class Parted {
 public:
  Parted(const scene::Scene& scene, const scene::Crack& crack);
  /// Of wrenches about the blocks' centroids in the scene's outline; what acts between two of the parted blocks is to
  /// have no sum.
  [[nodiscard]] Thrust thrust(const statics::Wrenches& loads) const;

 private:
  std::vector<int> blocks_;
  std::vector<statics::Point> centroids_;
  statics::Point mouth_;
  statics::Point end_;
};

/// The same joint with open_at_mouth_m and open_at_end_m found: all of its length where no closed part can balance the
/// thrust. `law` and `known` give the uplift.
Joint opened(scene::Uplift law, const scene::KnownHeads& known, Joint joint, const Thrust& thrust);

}  // namespace blockweir::joints
