// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the body of water that wets a crack's end.
#pragma once

#include <array>
#include <optional>

#include "bridge/scene/cracks.hpp"
#include "fluid/hydrostatic/pools.hpp"

namespace blockweir::hydrostatic {

class CrackPools {
 public:
  CrackPools(const scene::Scene& scene, const std::vector<scene::Crack>& cracks);

  /// The level [m] of the water that wets the outlines at the mouth or the end of crack `k`, located at `place`; none
  /// if no water does. Of several bodies, the one with level `expected_m` counts, otherwise the nearest.
  [[nodiscard]] std::optional<double> level(std::size_t k, bool mouth, const Point& place, double expected_m,
                                            const std::vector<WaterBody>& bodies,
                                            const std::vector<std::vector<Point>>& outlines) const;

 private:
  /// The continuation of a block beyond the crack's end: an edge from the fraction s on. Water on the crack's own side
  /// may belong to its other end.
  struct Beyond {
    int block = 0;
    int edge = 0;
    double s = 0;
    bool forwards = true;
  };
  using Beside = std::array<Beyond, 2>;

  static Beyond beyond(const scene::Block& block, int number, int edge, double s, double s_inside);

  double near_m_ = 0;
  std::vector<std::array<Beside, 2>> ends_;  ///< mouth, end
};

}  // namespace blockweir::hydrostatic
