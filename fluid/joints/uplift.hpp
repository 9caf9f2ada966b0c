// SPDX-License-Identifier: GPL-3.0-or-later
// The water pressure along a joint, for the uplift laws of a scene. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <vector>

#include "bridge/scene/uplift.hpp"

namespace blockweir::joints {

/// Water at an end of a joint.
struct End {
  double pressure_pa = 0;
  double height_m = 0;  ///< elevation y of that end
};

/// A joint in water; its upstream end is its mouth.
struct Joint {
  End mouth;
  End end;
  double length_m = 0;
  double water_n_per_m3 = 9810;  ///< rho g
  double open_at_mouth_m = 0;    ///< open length, from the mouth
  double open_at_end_m = 0;
  std::vector<scene::Bend> bends{};  ///< elevations are linear between them and the ends
};

/// Pressure [Pa] at distances [m] from the joint's mouth, linear in between.
class Profile {
 public:
  struct Knot {
    double at_m;
    double pressure_pa;
  };

  /// Add points in order; of several at one place the last counts beyond it.
  void add(double at_m, double pressure_pa) { knots_.push_back({at_m, pressure_pa}); }
  [[nodiscard]] double pressure(double at_m) const;
  [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }
  /// Force [N/m] and its moment about the mouth [N], along the joint's normal.
  [[nodiscard]] double force() const;
  [[nodiscard]] double moment_about_mouth() const;

 private:
  std::vector<Knot> knots_;
};

/// triangular: linear from the mouth's pressure to the end's; full: the higher of both; drained: through the pressure
/// at the drain (fluid/joints/drain.hpp); cracked: water at rest with an end's head along the open length from
/// there, in between linear, or drained if the crack has not reached the drain; heads: through the piezometers, whose
/// heads above the end's are proportional to the mouth's.
Profile uplift(scene::Uplift law, const scene::KnownHeads& known, const Joint& joint);

}  // namespace blockweir::joints
