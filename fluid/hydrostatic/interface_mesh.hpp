// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary elements of the reservoir on the blocks, and the hydrostatic pressure at their nodes (9).
#pragma once

#include <vector>

#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// P = P0 + rho g z, z the depth under the level; zero above it.
struct Hydrostatics {
  double weight_n_per_m3 = 9810;  ///< rho g
  double atmosphere_pa = 0;       ///< P0, on wet faces alone
  double level_m = 0;

  [[nodiscard]] double pressure(double y) const {
    return y <= level_m ? atmosphere_pa + weight_n_per_m3 * (level_m - y) : 0;
  }
};

/// Adds the elements of wet intervals to `load`. Elements are counted from an edge's ends, n to an edge, so that
/// they stay where they are when the level moves; the one that the surface cuts keeps its wet part.
void add_wet_elements(const std::vector<std::vector<Point>>& outlines, const std::vector<WetInterval>& wet,
                      const Hydrostatics& water, int elements_per_face, wire::Load& load);

}  // namespace blockweir::hydrostatic
