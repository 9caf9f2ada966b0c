// SPDX-License-Identifier: GPL-3.0-or-later
// Forces and stresses on surfaces that run through the structure, as an engineer checks them by hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bridge/wire/message.hpp"
#include "solid/watch/joint_sums.hpp"

namespace blockweir::solid {

/// Of a joint, or of joints in one line. Stresses are those of the gravity method without tension: of one face
///   N/L (1 +- 6 (1/2 - r)), beyond the middle third 2 N/(3 r L) on the 3 r L that is pressed,
/// r the resultant's way from the downstream end over the length; of faces beside a gallery as `linear_stress` has it.
struct JointRow {
  std::string name;
  double length_m = 0;                   ///< from end to end
  double faces_length_m = 0;             ///< where faces touch; shorter by the width of galleries
  double normal_n_per_m = 0;             ///< effective, without the water pressure in the joint; compression positive
  double shear_n_per_m = 0;              ///< absolute value
  double uplift_n_per_m = 0;             ///< water pressure in the joint, pushing the faces apart
  double moment_n = 0;                   ///< of the normal force about the middle, positive if it acts downstream of it
  std::optional<double> sliding_factor;  ///< present strength over shear; none without shear
  std::optional<double> residual_sliding_factor;    ///< the same after the bond is broken
  std::optional<double> resultant_from_downstream;  ///< over the length; none without compression
  double cracked_length_m = 0;                      ///< of the faces
  std::optional<double> bonded_length_m;  ///< that has cohesion or tension strength now; none where none is stated
  double heel_stress_pa = 0;              ///< at the upstream end; tension positive
  double toe_stress_pa = 0;               ///< at the downstream end
  Point upstream_end_m;
  Point downstream_end_m;
  std::vector<ForceSum> sums;  ///< forces above the surface, moments about its downstream end
};

/// Of a joint that is only a part of what divides the structure: it has no factor of its own.
struct JointPart {
  std::string name;
  double length_m = 0;
  double normal_n_per_m = 0;  ///< these as in a row
  double shear_n_per_m = 0;
  double uplift_n_per_m = 0;
  double strength_n_per_m = 0;  ///< c L + N tan(phi), with the bond as it is now
};

/// Of the joints with these names, by `Surfaces::parts`.
std::vector<JointPart> joint_parts(const Solid& solid, const wire::Load& water, const std::vector<std::string>& names);

/// `water`: the present water load.
std::vector<JointRow> joint_table(const Solid& solid, const wire::Load& water, const std::vector<WaterPart>& parts);

/// Name, length, downstream end and sums only, of all surfaces: loads of a structure that is not in equilibrium.
std::vector<JointRow> loads_on_joints(const Solid& solid, const wire::Load& water, const std::vector<WaterPart>& parts);

}  // namespace blockweir::solid
