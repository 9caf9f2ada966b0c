// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/crack_length.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "bridge/statics/loads.hpp"

namespace blockweir::joints {
namespace {

enum class OpenFrom { mouth, end };

/// A joint that opens from one side.
class Opening {
 public:
  Opening(scene::Uplift law, const scene::KnownHeads& known, const Joint& joint, const Thrust& thrust, OpenFrom side)
      : law_(law), known_(known), joint_(joint), thrust_(thrust), side_(side) {}

  [[nodiscard]] double found() const {
    const Balance closed = balance(0);
    if (closed.effective_n_per_m <= 0) return joint_.length_m;  // it floats
    if (closed.excess_n >= 0) return 0;
    // A drain that the crack reaches drains no more: the uplift jumps there.
    std::vector<double> ends = {0};
    if (known_.drain) ends.push_back(from_side(known_.drain->station_m));
    ends.push_back(joint_.length_m);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double low = ends[i - 1];
      const double high = std::nextafter(ends[i], low);
      if (holds(low)) return low;
      if (holds(high)) return first_that_holds(low, high);
    }
    return joint_.length_m;
  }

 private:
  [[nodiscard]] double from_side(double station_m) const {
    return side_ == OpenFrom::mouth ? station_m : joint_.length_m - station_m;
  }
  /// Effective normal force, and N r - M_U - (N - U) b/3, where that much is open.
  struct Balance {
    double effective_n_per_m;
    double excess_n;
  };
  [[nodiscard]] Balance balance(double open_m) const {
    Joint joint = joint_;
    (side_ == OpenFrom::mouth ? joint.open_at_mouth_m : joint.open_at_end_m) = open_m;
    const Profile water = uplift(law_, known_, joint);
    const double force = water.force();
    const double about_mouth = water.moment_about_mouth();
    const double about_end = joint.length_m * force - about_mouth;
    const bool from_mouth = side_ == OpenFrom::mouth;
    const double lever = from_mouth ? thrust_.about_end_n - about_end : thrust_.about_mouth_n - about_mouth;
    const double effective = thrust_.normal_n_per_m - force;
    return {effective, lever - effective * (joint.length_m - open_m) / 3};
  }
  [[nodiscard]] bool holds(double open_m) const {
    const Balance b = balance(open_m);
    return b.effective_n_per_m > 0 && b.excess_n >= 0;
  }
  /// By halves: at `low` the excess may be lacking or the effective force, so that neither need change its sign.
  [[nodiscard]] double first_that_holds(double low, double high) const {
    for (;;) {
      const double middle = (low + high) / 2;
      if (middle <= low || middle >= high) return high;
      (holds(middle) ? high : low) = middle;
    }
  }

  scene::Uplift law_;
  const scene::KnownHeads& known_;
  const Joint& joint_;
  const Thrust& thrust_;
  OpenFrom side_;
};

}  // namespace

Parted::Parted(const scene::Scene& scene, const scene::Crack& crack)
    : blocks_(scene::parted_by(scene, crack)),
      centroids_(statics::centroids_of(scene)),
      mouth_(crack.mouth()),
      end_(crack.end()) {}

Thrust Parted::thrust(const statics::Wrenches& loads) const {
  const statics::Point along = (end_ - mouth_).normalized();
  statics::Point force = statics::Point::Zero();
  double about_mouth = 0;  // counter-clockwise
  statics::Point centre = statics::Point::Zero();
  for (const int b : blocks_) {
    const statics::Wrench& w = loads[at(b)];
    force += w.head<2>();
    about_mouth += w[2] + geometry::cross(centroids_[at(b)] - mouth_, w.head<2>());
    centre += centroids_[at(b)] / static_cast<double>(blocks_.size());
  }
  // Of the joint's two normals, the one into the structure above it.
  const double side = geometry::cross(along, centre - mouth_) < 0 ? -1 : 1;
  Thrust thrust;
  thrust.normal_n_per_m = -side * geometry::cross(along, force);
  thrust.about_mouth_n = -side * about_mouth;
  thrust.about_end_n = (end_ - mouth_).norm() * thrust.normal_n_per_m - thrust.about_mouth_n;
  return thrust;
}

Joint opened(scene::Uplift law, const scene::KnownHeads& known, Joint joint, const Thrust& thrust) {
  const double from_mouth = Opening(law, known, joint, thrust, OpenFrom::mouth).found();
  const double from_end = from_mouth == 0 ? Opening(law, known, joint, thrust, OpenFrom::end).found() : 0;
  joint.open_at_mouth_m = from_mouth;
  joint.open_at_end_m = from_end;
  if (std::max(from_mouth, from_end) < joint.length_m) return joint;
  // Open all along, it has the water of the end that presses more.
  Joint other = joint;
  std::swap(other.open_at_mouth_m, other.open_at_end_m);
  return uplift(law, known, other).force() > uplift(law, known, joint).force() ? other : joint;
}

}  // namespace blockweir::joints
