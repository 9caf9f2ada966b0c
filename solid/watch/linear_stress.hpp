// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of the gravity method on a joint: linear along it, without tension, on its faces alone. A gallery in the
// joint bears nothing.
#pragma once

#include <vector>

namespace blockweir::solid {

/// Where faces lie on each other [m], along the joint from its upstream end.
struct FaceStretch {
  double from_m = 0;
  double to_m = 0;
};

/// In order, those that touch or overlap made one.
std::vector<FaceStretch> joined(std::vector<FaceStretch> stretches, double near_m);

struct LinearStress {
  double upstream_pa = 0;    ///< at the upstream end of the first stretch; compression positive
  double downstream_pa = 0;  ///< at the downstream end of the last
  double open_m = 0;         ///< of the faces: what the resultant leaves without stress
};

/// Of a normal force [N per metre] above 0 whose resultant is at that place [m] from the upstream end. `faces`: in
/// order, not empty. Where all is pressed, N/A + N (x_r - x_c)(x - x_c)/I; else a line that is zero where the rest
/// opens, of which the stress times lever is the force's. A resultant beyond the faces leaves all open.
LinearStress linear_stress(const std::vector<FaceStretch>& faces, double normal_n_per_m, double resultant_m);

}  // namespace blockweir::solid
