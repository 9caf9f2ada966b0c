// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures on the blocks' edges: sampled in the water where an edge is open; by the scene's uplift law in cracks; and
// hydrostatic from the mouths in slots too narrow for the mesh.
#pragma once

#include <array>

#include "fluid/joints/uplift.hpp"
#include "fluid/openfoam/plugin/joint_flow.hpp"
#include "fluid/openfoam/plugin/pockets.hpp"
#include "fluid/openfoam/plugin/water_state.hpp"
#include "fluid/openfoam/sample_points.hpp"

namespace blockweir::openfoam {

class EdgePressures {
 public:
  EdgePressures(const ImmersedBlocks& blocks, const WaterState& water);

  /// Panels of all loaded blocks at their present positions; the same on all ranks. `flow`: flow through joints, or
  /// null.
  void sample(JointFlow* flow, wire::Load& load);

  /// A piece of an edge that was wet in the last sampling.
  struct Wetted {
    int block = 0;
    Point middle;
    Point push;       ///< outward normal times length and openness [m]
    Point looked_at;  ///< where its water was sampled
  };
  [[nodiscard]] const std::vector<Wetted>& wetted() const { return wetted_; }

 private:
  void find_targets();
  [[nodiscard]] std::vector<double> fills_at(const std::vector<Point>& points) const;
  [[nodiscard]] std::vector<double> look() const;
  [[nodiscard]] PressureLine first_line(std::size_t looks, const std::vector<double>& lines) const;
  void add_open(const EdgeElement& element, std::size_t looks, const std::vector<double>& lines, wire::Load& load);
  void add_slot(const EdgeElement& element, const std::vector<Mouth>& mouths, const std::vector<double>& lines,
                wire::Load& load) const;
  void add_cracks(const std::vector<std::array<joints::End, 2>>& ends, wire::Load& load) const;

  const ImmersedBlocks& blocks_;
  const WaterState& water_;
  Pockets pockets_;
  ElementRules rules_;
  Targets targets_;
  std::vector<Point> openings_;  ///< of cracks, alternately mouth and end
  std::vector<Wetted> wetted_;
  std::vector<Pose> last_poses_;
};

}  // namespace blockweir::openfoam
