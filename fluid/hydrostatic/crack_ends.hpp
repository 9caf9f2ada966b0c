// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of cracks with a pool's pressure that no open water reaches: buried ends, or ends behind the structure.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bridge/scene/cracks.hpp"
#include "fluid/hydrostatic/wet_edges.hpp"

namespace blockweir::hydrostatic {

class CrackEnds {
 public:
  /// The end of a crack: its assumed pressure, and its present position.
  struct End {
    bool upstream = true;
    Point place;
    double pressure_pa = 0;
  };

  /// `cracks` as drawn in the scene: an end that lies on another crack may get its water from that one.
  CrackEnds(const scene::Scene& scene, const std::vector<scene::Crack>& cracks);

  /// Records the end of crack `k` with the highest pressure that is not close to any interval of `open_water`.
  void look(std::size_t k, const End& end, const std::vector<std::vector<Point>>& outlines,
            const std::vector<WetInterval>& open_water);
  /// Empty if each end has its water.
  [[nodiscard]] std::string warning() const;

 private:
  struct OnAnother {
    bool mouth = false;
    bool end = false;
  };
  const scene::Scene& scene_;
  std::vector<OnAnother> on_another_;
  std::vector<std::string> names_;
  std::vector<std::array<bool, 2>> of_ground_;  ///< does the crack begin, does it end between fixed blocks?
  End driest_;
  std::size_t crack_ = 0;
};

}  // namespace blockweir::hydrostatic
