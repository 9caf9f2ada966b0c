// SPDX-License-Identifier: GPL-3.0-or-later
// The pressure of water along a joint, by the laws that a scene can name. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <vector>

#include "bridge/scene/uplift.hpp"

namespace blockweir::joints {

/// Water at an end of a joint.
struct End {
  double pressure_pa = 0;
  double height_m = 0;  ///< of that end, on the y axis
};

/// A joint in water; its upstream end is its mouth. Heights in between are those of the straight line from end to end.
struct Joint {
  End mouth;
  End end;
  double length_m = 0;
  double water_n_per_m3 = 9810;  ///< rho g
  double open_at_mouth_m = 0;    ///< length that is open, from the mouth
  double open_at_end_m = 0;
};

/// Pressure [Pa] at places along the joint [m] from its mouth, linear in between.
class Profile {
 public:
  struct Knot {
    double at_m;
    double pressure_pa;
  };

  /// Knots come by place; of several at one place the last counts beyond it.
  void add(double at_m, double pressure_pa) { knots_.push_back({at_m, pressure_pa}); }
  [[nodiscard]] double pressure(double at_m) const;
  [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }
  /// Force [N/m] and its moment about the mouth [N], both faces' normals being the joint's.
  [[nodiscard]] double force() const;
  [[nodiscard]] double moment_about_mouth() const;

 private:
  std::vector<Knot> knots_;
};

/// triangular: linear from the mouth's pressure to the end's; full: the higher of both; drained: through that at
/// the drain (fluid/joints/drain.hpp); cracked: an end's pressure where the joint is open from there, in between as
/// without or with a drain that the crack has not reached; heads: through the piezometers, whose heads above the end's
/// follow the mouth's in proportion.
Profile uplift(scene::Uplift law, const scene::KnownHeads& known, const Joint& joint);

}  // namespace blockweir::joints
