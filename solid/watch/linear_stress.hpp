// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of the gravity method on a joint: linear along it, without tension, only where faces touch. A gallery in the
// joint carries nothing.
#pragma once

#include <vector>

namespace blockweir::solid {

/// Where the faces touch [m], along the joint from its upstream end.
struct FaceStretch {
  double from_m = 0;
  double to_m = 0;
};

/// Sorted, with those that touch or overlap merged.
std::vector<FaceStretch> joined(std::vector<FaceStretch> stretches, double near_m);

struct LinearStress {
  double upstream_pa = 0;    ///< at the upstream end of the first stretch; compression positive
  double downstream_pa = 0;  ///< at the downstream end of the last
  double open_m = 0;         ///< length of faces without compression
};

/// Stress for a normal force [N per metre] above 0 with its resultant at this place [m] from the upstream end. `faces`:
/// sorted, not empty. If all is in compression, N/A + N (x_r - x_c)(x - x_c)/I; otherwise a line that is zero where the
/// joint opens and has the moment of the force. A resultant beyond the faces: all open.
LinearStress linear_stress(const std::vector<FaceStretch>& faces, double normal_n_per_m, double resultant_m);

}  // namespace blockweir::solid
