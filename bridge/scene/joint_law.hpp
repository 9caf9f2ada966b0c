// SPDX-License-Identifier: GPL-3.0-or-later
// The law of a joint as a scene states it, and the keys that state it. How contacts follow it:
// solid/contact/joint_law.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "bridge/scene/uplift.hpp"

namespace blockweir::scene {

/// Mohr-Coulomb: |shear| <= cohesion * bonded length + N tan(friction angle);
/// tension <= tension strength * bonded length.
struct JointLaw {
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
    constexpr double degree = std::numbers::pi / 180;
    for (double* angle_deg : {&friction_angle_deg, &residual_friction_angle_deg}) {
      *angle_deg = std::atan(std::tan(*angle_deg * degree) / factor) / degree;
    }
    cohesion_pa /= factor;
  }
};

/// A key of [joint] that states one member of the law; the reader and its checks go by it.
struct JointLawKey {
  enum class Range { any, not_negative, angle };

  const char* name;
  std::variant<double JointLaw::*, std::optional<double> JointLaw::*, bool JointLaw::*> member;
  Range range = Range::any;
  /// Has the law a value of it that does nothing? Null: it always does something.
  bool (*is_idle)(const JointLaw&) = nullptr;
  const char* without = "";                   ///< what the joint then lacks
  std::vector<const char*> supplied_by = {};  ///< keys of what it lacks
};

/// In the order of the reference of keys.
inline const std::vector<JointLawKey>& joint_law_keys() {
  using Range = JointLawKey::Range;
  constexpr const char* flow = "flow of water";
  static const std::vector<JointLawKey> keys = {
      {"friction_angle_deg", &JointLaw::friction_angle_deg, Range::angle},
      {"residual_friction_angle_deg", &JointLaw::residual_friction_angle_deg, Range::angle},
      {"cohesion_pa", &JointLaw::cohesion_pa, Range::not_negative},
      {"tension_strength_pa", &JointLaw::tension_strength_pa, Range::not_negative},
      {"bonded_length_m",
       &JointLaw::bonded_length_m,
       Range::not_negative,
       [](const JointLaw& law) { return law.bonded_length_m && !law.is_bonded(); },
       "bond",
       {"cohesion_pa", "tension_strength_pa"}},
      {"keeps_cohesion",
       &JointLaw::keeps_cohesion,
       Range::any,
       [](const JointLaw& law) { return law.keeps_cohesion && !law.is_bonded(); },
       "bond",
       {"cohesion_pa", "tension_strength_pa"}},
      {"softening_slip_m",
       &JointLaw::softening_slip_m,
       Range::not_negative,
       [](const JointLaw& law) { return law.softening_slip_m > 0 && !law.weakens(); },
       "bond or residual friction",
       {"cohesion_pa", "tension_strength_pa", "residual_friction_angle_deg"}},
      {"dilation_angle_deg", &JointLaw::dilation_angle_deg, Range::angle},
      {"dilation_limit_m",
       &JointLaw::dilation_limit_m,
       Range::not_negative,
       [](const JointLaw& law) { return law.dilation_limit_m && law.dilation_angle_deg == 0; },
       "dilation_angle_deg",
       {"dilation_angle_deg"}},
      {"hydraulic_aperture_m",
       &JointLaw::hydraulic_aperture_m,
       Range::not_negative,
       [](const JointLaw& law) {
         return !law.has_flow() && law.hydraulic_aperture_m != JointLaw{}.hydraulic_aperture_m;
       },
       flow,
       {"uplift"}},
      {"least_aperture_m",
       &JointLaw::least_aperture_m,
       Range::not_negative,
       [](const JointLaw& law) { return !law.has_flow() && law.least_aperture_m; },
       flow,
       {"uplift"}},
      {"largest_aperture_m",
       &JointLaw::largest_aperture_m,
       Range::not_negative,
       [](const JointLaw& law) { return !law.has_flow() && law.largest_aperture_m; },
       flow,
       {"uplift"}},
      {"aperture_stiffness_pa_per_m",
       &JointLaw::aperture_stiffness_pa_per_m,
       Range::not_negative,
       [](const JointLaw& law) { return !law.has_flow() && law.aperture_stiffness_pa_per_m; },
       flow,
       {"uplift"}},
      {"aperture_pressure_pa",
       &JointLaw::aperture_pressure_pa,
       Range::any,
       [](const JointLaw& law) { return !law.has_flow() && law.aperture_pressure_pa != 0; },
       flow,
       {"uplift"}},
  };
  return keys;
}

}  // namespace blockweir::scene
