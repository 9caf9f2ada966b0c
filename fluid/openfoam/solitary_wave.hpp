// SPDX-License-Identifier: GPL-3.0-or-later
// Boussinesq's solitary wave travelling downstream: eta = H sech^2(k (x - x0)), k^2 = 3 H/(4 h^3), with the speed c =
// sqrt(g (h + H)); u = c eta/(h + eta) over the whole depth, and the vertical velocity from continuity.
#pragma once

#include <cmath>

#include "bridge/scene/scene.hpp"

namespace blockweir::openfoam {

struct SolitaryWave {
  double height_m = 0;
  double depth_m = 0;  ///< of the still water
  double crest_x_m = 0;
  double gravity_m_per_s2 = 9.81;

  [[nodiscard]] double wave_number() const { return std::sqrt(0.75 * height_m / depth_m) / depth_m; }
  /// Farther from the crest the wave is lower than a hundredth of its height [m].
  [[nodiscard]] double reach_m() const { return 3 / wave_number(); }

  [[nodiscard]] double elevation(double x) const {
    const double sech = 1 / std::cosh(wave_number() * (x - crest_x_m));
    return height_m * sech * sech;
  }
  /// At a height above the bed.
  [[nodiscard]] scene::Point velocity(double x, double above_bed_m) const {
    const double c = std::sqrt(gravity_m_per_s2 * (depth_m + height_m));
    const double eta = elevation(x);
    const double slope = -2 * wave_number() * std::tanh(wave_number() * (x - crest_x_m)) * eta;
    const double depth = depth_m + eta;
    return {c * eta / depth, -above_bed_m * c * depth_m * slope / (depth * depth)};
  }
};

}  // namespace blockweir::openfoam
