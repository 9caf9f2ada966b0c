// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's loads as generalized forces: weight, initial stress, inertia of a moving base, point, line and body loads,
// pressures on faces.
#pragma once

#include <vector>

#include "solid/block/base_motion.hpp"
#include "solid/block/moving_parts.hpp"

namespace blockweir::solid {

class Loads {
 public:
  Loads(const scene::Scene& scene, const MovingParts& parts);

  /// Weight and initial stress of a part.
  [[nodiscard]] const Vector6& constant(std::size_t part) const { return constant_[part]; }
  /// External generalized forces [N per metre, N] on every part in a step, with the water's panels on the scene's
  /// blocks; directions follow the given placements. `base_moves`: false: weight and first loads act on a base at rest.
  void evaluate(const scene::TimeSpan& step, const std::vector<Panel>& water, const std::vector<Placement>& placements,
                std::vector<Vector6>& forces, bool base_moves = false) const;

 private:
  struct PointForce {
    Anchor at;
    const scene::PointLoad* load;
  };
  struct Face {
    Panel panel;
    const scene::FacePressure* load;
  };
  struct Line {
    Panel panel;  ///< where it acts; without pressure
    const scene::LineLoad* load;
  };
  void add_lines(const scene::TimeSpan& step, const std::vector<Placement>& placements,
                 std::vector<Vector6>& forces) const;
  void add_bodies(const scene::TimeSpan& step, std::vector<Vector6>& forces) const;
  void add_base(const scene::TimeSpan& step, std::vector<Vector6>& forces) const;

  const MovingParts& parts_;
  const scene::Scene& scene_;
  std::vector<Vector6> constant_;  ///< weight and initial stress
  std::vector<PointForce> points_;
  std::vector<Face> faces_;
  std::vector<Line> lines_;
  BaseMotion base_;
};

}  // namespace blockweir::solid
