// SPDX-License-Identifier: GPL-3.0-or-later
// Maps the boundary of the water, piece by piece, back to the edges of the blocks.
#pragma once

#include <utility>
#include <vector>

#include "fluid/joints/water_grid.hpp"

namespace blockweir::hydrostatic {

using joints::Extent;
using joints::Grid;
using joints::Piece;
using joints::Ring;
using scene::Point;

/// Part of an edge of a block, fractions 0..1 along the edge.
struct WetInterval {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
};

/// The edges of blocks that reach below a level, and their wet parts.
class WetEdges {
 public:
  /// `growth_m`: distance by which the water's boundary was moved; its direction is known to one unit of the grid.
  WetEdges(const std::vector<std::vector<Point>>& outlines, double level_m, double growth_m, const Grid& grid);

  /// A piece of the boundary, with the water on its left.
  void add(const Piece& boundary);
  /// All pieces by block, edge and place, with ends snapped to their place and overlaps merged.
  [[nodiscard]] std::vector<WetInterval> intervals() const;

 private:
  /// The part of a block's edge below the level.
  struct Sunken {
    int block;
    int edge;
    Point from;
    Point along;
    double length_m;
    double s_from;
    double s_to;
    double surface;  ///< fraction at which the level cuts the edge's line, or none in 0..1
  };
  struct Heights {
    double bottom_m;
    double top_m;

    [[nodiscard]] bool beyond(const Heights& h) const { return bottom_m > h.top_m || top_m < h.bottom_m; }
  };
  static constexpr std::size_t group = 16;
  struct Part {
    std::size_t sunken;
    double s_from;
    double s_to;
  };

  /// Adds to parallel edges no farther than `near_m`; `found`: positions [m] measured backwards from the edge's end.
  void add_near(const Piece& boundary, double near_m, std::vector<std::pair<double, double>>& found);

  std::vector<Sunken> edges_;
  std::vector<Heights> heights_;  ///< of the edges; what a search looks at first lies close together
  std::vector<Heights> groups_;   ///< of `group` edges after each other, which lie close together, too
  std::vector<Part> parts_;
  double level_m_;
  double growth_m_;
  double unit_m_;
  double tiny_m_;
};

}  // namespace blockweir::hydrostatic
