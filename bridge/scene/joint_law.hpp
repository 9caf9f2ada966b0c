// SPDX-License-Identifier: GPL-3.0-or-later
// The law of a joint as a scene states it. How contacts follow it: solid/contact/joint_law.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bridge/scene/barton_bandis.hpp"
#include "bridge/scene/strength_line.hpp"
#include "bridge/scene/uplift.hpp"

namespace blockweir::scene {

/// The laws of friction that changes with the normal stress, by priority: a new one is a file of its own, and a name
/// here.
using CurvedFriction = FirstOf<BartonBandis>;

/// Mohr-Coulomb: |shear| <= cohesion * bonded length + N tan(friction angle), or its CurvedFriction in place of the
/// latter; tension <= tension strength * bonded length.
struct JointLaw : CurvedFriction {
  double friction_angle_deg = 30;
  double residual_friction_angle_deg = 30;  ///< after the bond has failed; default: the peak angle
  double cohesion_pa = 0;
  double tension_strength_pa = 0;
  std::optional<double> bonded_length_m;   ///< of the whole joint; default: all of it
  bool keeps_cohesion = false;             ///< true: cohesion and tension survive slip and opening
  double softening_slip_m = 0;             ///< slip over which cohesion, tension and peak friction fade; 0: brittle
  double dilation_angle_deg = 0;           ///< slip opens the joint by its tangent
  std::optional<double> dilation_limit_m;  ///< slip beyond which it opens no further
  Uplift uplift = Uplift::none;
  KnownHeads known_heads{};  ///< of the laws that need some
  // Of water that flows through it, uplift = "flow".
  double hydraulic_aperture_m = 2e-4;      ///< of the closed joint
  std::optional<double> least_aperture_m;  ///< default: a hundredth of the closed joint's
  std::optional<double>
      largest_aperture_m;  ///< default: [water] open_crack_width_m; wider, it is as easy as open water
  std::optional<double> aperture_stiffness_pa_per_m;  ///< pressure over the widening that it causes; none: it does not
  double aperture_pressure_pa = 0;                    ///< at which the closed joint has its hydraulic aperture
  bool operator==(const JointLaw&) const = default;

  [[nodiscard]] bool has_flow() const { return uplift == Uplift::flow; }
  [[nodiscard]] bool is_bonded() const { return cohesion_pa > 0 || tension_strength_pa > 0; }
  /// Has it a strength that can be lost?
  [[nodiscard]] bool weakens() const { return is_bonded() || residual_friction_angle_deg != friction_angle_deg; }
  /// tan(friction angle)
  [[nodiscard]] double friction() const { return std::tan(friction_angle_deg * std::numbers::pi / 180); }
  /// Pa, the tension that the joint bears. Mohr-Coulomb's |shear| <= c + sigma tan(phi) ends at the tension c/tan(phi):
  /// what a law states beyond it counts as that, else a joint would bear shear under a tension at which it has no
  /// strength left.
  [[nodiscard]] double tension_cut_off_pa() const {
    const double slope = friction();
    return slope > 0 ? std::min(tension_strength_pa, cohesion_pa / slope) : tension_strength_pa;
  }
  /// Strength reduction: tan(phi) and c over the factor.
  void reduce(double factor) {
    cohesion_pa /= factor;
    if (bends()) {
      curve_over *= factor;
      return;
    }
    constexpr double degree = std::numbers::pi / 180;
    for (double* angle_deg : {&friction_angle_deg, &residual_friction_angle_deg}) {
      *angle_deg = std::atan(std::tan(*angle_deg * degree) / factor) / degree;
    }
  }
};

}  // namespace blockweir::scene
