// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure on the blocks' edges: sampled in the water outside where an edge is open, by the scene's law in cracks.
#pragma once

#include "fluid/openfoam/plugin/water_state.hpp"

namespace blockweir::openfoam {

class EdgePressures {
 public:
  EdgePressures(const ImmersedBlocks& blocks, const WaterState& water) : blocks_(blocks), water_(water) {}

  /// Panels of all loaded blocks where they are now; the same on all ranks.
  void sample(wire::Load& load);

  /// A piece of an edge that water pressed on when last sampled.
  struct Wetted {
    int block = 0;
    Point middle;
    Point push;       ///< outward normal times length and openness [m]
    Point looked_at;  ///< where its water was looked up
  };
  [[nodiscard]] const std::vector<Wetted>& wetted() const { return wetted_; }

 private:
  /// A piece of an edge that one cell's water presses on.
  struct Element {
    int block = 0;
    int edge = 0;
    double s_from = 0;
    double s_to = 1;
    Point from;
    Point to;
    Point normal;         ///< outwards
    double openness = 1;  ///< 0: a joint or a crack that carries no water in the mesh; 1: open
  };
  /// Pressures of a crack's two ends [Pa].
  struct CrackPressure {
    double mouth = 0;
    double end = 0;
  };

  void find_elements();
  void split(int block, int edge, const Point& from, const Point& to);
  [[nodiscard]] double gap_beyond(const Element& element) const;
  void look_along(const Point& from, const Point& direction, std::vector<double>& lines) const;
  void add_open(const Element& element, const double* lines, wire::Load& load);
  void add_cracks(const std::vector<CrackPressure>& pressures, wire::Load& load) const;

  const ImmersedBlocks& blocks_;
  const WaterState& water_;
  std::vector<Element> elements_;
  std::vector<Wetted> wetted_;
  std::vector<Pose> last_poses_;
  std::vector<double> cuts_;
};

}  // namespace blockweir::openfoam
