// SPDX-License-Identifier: GPL-3.0-or-later
// Water's boundary, piece by piece, found again on the edges of the blocks.
#pragma once

#include <utility>
#include <vector>

#include "fluid/hydrostatic/water_grid.hpp"

namespace blockweir::hydrostatic {

/// Part of an edge of a block, fractions 0..1 along the edge.
struct WetInterval {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
};

/// The edges of blocks that reach below a level, and which parts of them are wet.
class WetEdges {
 public:
  /// `growth_m`: by how much the water's boundary has been moved, whose direction is known to a unit of the grid.
  WetEdges(const std::vector<std::vector<Point>>& outlines, double level_m, double growth_m, const Grid& grid);

  /// A piece of the boundary, water on its left.
  void add(const Piece& boundary);
  /// What has been added, by block, edge and place: ends put where they belong, what overlaps joined.
  [[nodiscard]] std::vector<WetInterval> intervals() const;

 private:
  /// What of an edge of a block is under the level.
  struct Sunken {
    int block;
    int edge;
    Point from;
    Point along;
    double length_m;
    double s_from;
    double s_to;
    double surface;  ///< fraction at which the level cuts the edge's line, or none within 0..1
  };
  struct Heights {
    double bottom_m;
    double top_m;
  };
  struct Part {
    std::size_t sunken;
    double s_from;
    double s_to;
  };

  /// To edges that run along it and are no farther than `near_m`; `found`: where [m] from its end backwards.
  void add_near(const Piece& boundary, double near_m, std::vector<std::pair<double, double>>& found);

  std::vector<Sunken> edges_;
  std::vector<Heights> heights_;  ///< of the edges; what a search looks at first lies close together
  std::vector<Part> parts_;
  double level_m_;
  double growth_m_;
  double unit_m_;
  double tiny_m_;
};

}  // namespace blockweir::hydrostatic
