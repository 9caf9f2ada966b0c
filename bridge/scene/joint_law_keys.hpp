// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a joint law.
#pragma once

#include <vector>

#include "bridge/scene/joint_law.hpp"
#include "bridge/scene/joint_law_key.hpp"

namespace blockweir::scene {

using JointLawKey = LawKey<JointLaw>;

inline std::vector<JointLawKey> keys_of_strength() {
  using KeyRange = JointLawKey::Range;
  return {{"friction_angle_deg", &JointLaw::friction_angle_deg, KeyRange::angle},
          {"residual_friction_angle_deg", &JointLaw::residual_friction_angle_deg, KeyRange::angle},
          {"cohesion_pa", &JointLaw::cohesion_pa, KeyRange::not_negative},
          {"tension_strength_pa", &JointLaw::tension_strength_pa, KeyRange::not_negative},
          {"bonded_length_m",
           &JointLaw::bonded_length_m,
           KeyRange::not_negative,
           [](const JointLaw& law) { return law.bonded_length_m && !law.is_bonded(); },
           "bond",
           {"cohesion_pa", "tension_strength_pa"}},
          {"keeps_cohesion",
           &JointLaw::keeps_cohesion,
           KeyRange::any,
           [](const JointLaw& law) { return law.keeps_cohesion && !law.is_bonded(); },
           "bond",
           {"cohesion_pa", "tension_strength_pa"}},
          {"softening_slip_m",
           &JointLaw::softening_slip_m,
           KeyRange::not_negative,
           [](const JointLaw& law) { return law.softening_slip_m > 0 && !law.weakens(); },
           "bond or residual friction",
           {"cohesion_pa", "tension_strength_pa", "residual_friction_angle_deg"}},
          {"dilation_angle_deg", &JointLaw::dilation_angle_deg, KeyRange::angle},
          {"dilation_limit_m",
           &JointLaw::dilation_limit_m,
           KeyRange::not_negative,
           [](const JointLaw& law) { return law.dilation_limit_m && law.dilation_angle_deg == 0; },
           "dilation_angle_deg",
           {"dilation_angle_deg"}}};
}

/// Keys of seepage flow through the joint.
inline std::vector<JointLawKey> keys_of_flow() {
  using KeyRange = JointLawKey::Range;
  constexpr const char* flow = "flow of water";
  return {{"hydraulic_aperture_m",
           &JointLaw::hydraulic_aperture_m,
           KeyRange::not_negative,
           [](const JointLaw& law) {
             return !law.has_flow() && law.hydraulic_aperture_m != JointLaw{}.hydraulic_aperture_m;
           },
           flow,
           {"uplift"}},
          {"least_aperture_m",
           &JointLaw::least_aperture_m,
           KeyRange::not_negative,
           [](const JointLaw& law) { return !law.has_flow() && law.least_aperture_m; },
           flow,
           {"uplift"}},
          {"largest_aperture_m",
           &JointLaw::largest_aperture_m,
           KeyRange::not_negative,
           [](const JointLaw& law) { return !law.has_flow() && law.largest_aperture_m; },
           flow,
           {"uplift"}},
          {"aperture_stiffness_pa_per_m",
           &JointLaw::aperture_stiffness_pa_per_m,
           KeyRange::not_negative,
           [](const JointLaw& law) { return !law.has_flow() && law.aperture_stiffness_pa_per_m; },
           flow,
           {"uplift"}},
          {"aperture_pressure_pa",
           &JointLaw::aperture_pressure_pa,
           KeyRange::any,
           [](const JointLaw& law) { return !law.has_flow() && law.aperture_pressure_pa != 0; },
           flow,
           {"uplift"}}};
}

/// In the order of KEYS.md.
inline const std::vector<JointLawKey>& joint_law_keys() {
  static const std::vector<JointLawKey> keys = [] {
    std::vector<JointLawKey> all = keys_of_strength();
    CurvedFriction::append_keys(all);
    for (const JointLawKey& key : keys_of_flow()) all.push_back(key);
    return all;
  }();
  return keys;
}

}  // namespace blockweir::scene
