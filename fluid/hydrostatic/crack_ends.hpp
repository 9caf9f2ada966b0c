// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of cracks that have a pool's pressure though no open water reaches them: buried, or behind the structure.
#pragma once

#include <string>

#include "bridge/scene/cracks.hpp"
#include "fluid/hydrostatic/wet_edges.hpp"

namespace blockweir::hydrostatic {

class CrackEnds {
 public:
  /// What is taken of a crack's end: its pressure, and where it is now.
  struct End {
    bool upstream = true;
    Point place;
    double pressure_pa = 0;
  };

  /// `cracks` as the scene draws them: an end that lies on another crack may get its water from there.
  CrackEnds(const scene::Scene& scene, const std::vector<scene::Crack>& cracks);

  /// Keeps the end of crack `k` with the highest pressure that no interval of `open_water` comes near.
  void look(std::size_t k, const End& end, const std::vector<std::vector<Point>>& outlines,
            const std::vector<WetInterval>& open_water);
  /// Empty where each end has its water.
  [[nodiscard]] std::string warning() const;

 private:
  struct OnAnother {
    bool mouth = false;
    bool end = false;
  };
  const scene::Scene& scene_;
  std::vector<OnAnother> on_another_;
  std::vector<std::string> names_;
  End driest_;
  std::size_t crack_ = 0;
};

}  // namespace blockweir::hydrostatic
