// SPDX-License-Identifier: GPL-3.0-or-later
// The strength law of a joint, as a scene states it. Contacts apply it in solid/contact/joint_law.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bridge/scene/barton_bandis.hpp"
#include "bridge/scene/strength_line.hpp"
#include "bridge/scene/uplift.hpp"

namespace blockweir::scene {

/// Friction laws that depend on the normal stress, by priority. To add one, write its file and add its name
/// here.
using CurvedFriction = FirstOf<BartonBandis>;

/// Mohr-Coulomb: |shear| <= cohesion * bonded length + N tan(friction angle); a CurvedFriction replaces the last term.
/// Tension <= tension strength * bonded length.
struct JointLaw : CurvedFriction {
  double friction_angle_deg = 30;
  double residual_friction_angle_deg = 30;  ///< after the bond has failed; default: the peak angle
  double cohesion_pa = 0;
  double tension_strength_pa = 0;
  std::optional<double> bonded_length_m;   ///< of the joint; default: its whole length
  bool keeps_cohesion = false;             ///< true: slip and opening do not destroy them
  double softening_slip_m = 0;             ///< slip over which cohesion, tension and peak friction fade; 0: brittle
  double dilation_angle_deg = 0;           ///< slip opens the joint by the tangent of this angle
  std::optional<double> dilation_limit_m;  ///< slip after which the joint dilates no further
  Uplift uplift = Uplift::none;
  KnownHeads known_heads{};  ///< for the uplift laws that need measured heads
  // For seepage flow, uplift = "flow".
  double hydraulic_aperture_m = 2e-4;      ///< of the closed joint
  std::optional<double> least_aperture_m;  ///< default: a hundredth of hydraulic_aperture_m
  std::optional<double>
      largest_aperture_m;  ///< default: [water] open_crack_width_m; wider joints resist flow no more than open water
  std::optional<double> aperture_stiffness_pa_per_m;  ///< pressure over the widening that it causes; none: no widening
  double aperture_pressure_pa = 0;                    ///< pressure at which the closed joint has its hydraulic aperture
  bool operator==(const JointLaw&) const = default;

  [[nodiscard]] bool has_flow() const { return uplift == Uplift::flow; }
  [[nodiscard]] bool is_bonded() const { return cohesion_pa > 0 || tension_strength_pa > 0; }
  /// Whether the joint has strength that it can lose.
  [[nodiscard]] bool weakens() const { return is_bonded() || residual_friction_angle_deg != friction_angle_deg; }
  /// tan(friction angle)
  [[nodiscard]] double friction() const { return std::tan(friction_angle_deg * std::numbers::pi / 180); }
  /// Tension cut-off [Pa]. Mohr-Coulomb, |shear| <= c + sigma tan(phi), ends at the tension c/tan(phi). A larger stated
  /// tension strength is limited to that: otherwise a joint could carry shear at a tension where its shear strength is
  /// zero.
  [[nodiscard]] double tension_cut_off_pa() const {
    const double slope = friction();
    return slope > 0 ? std::min(tension_strength_pa, cohesion_pa / slope) : tension_strength_pa;
  }
  /// Strength reduction: divides tan(phi) and c by the factor.
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
