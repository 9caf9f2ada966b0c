// SPDX-License-Identifier: GPL-3.0-or-later
// Given loads of a scene as generalized forces: weight, point loads, pressures on faces.
#pragma once

#include <vector>

#include "solid/block/parts.hpp"

namespace blockweir::solid {

class Loads {
 public:
  Loads(const scene::Scene& scene, const Parts& parts);

  /// External generalized forces [N per metre, N] on every part at `time_s`, with the water's panels on the scene's
  /// blocks; directions follow the placements given.
  void evaluate(double time_s, const std::vector<Panel>& water, const std::vector<Placement>& placements,
                std::vector<Vector6>& forces) const;

 private:
  struct PointForce {
    Anchor at;
    const scene::PointLoad* load;
  };
  struct Face {
    Panel panel;
    const scene::FacePressure* load;
  };
  const Parts& parts_;
  std::vector<Vector6> weight_;
  std::vector<PointForce> points_;
  std::vector<Face> faces_;
  scene::NodalRule rule_;
};

}  // namespace blockweir::solid
