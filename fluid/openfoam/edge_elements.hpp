// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks' edges in pieces that one cell's water presses on, and what of them that water reaches. C++17: the
// OpenFOAM plugin includes this.
#pragma once

#include <limits>

#include "fluid/openfoam/polygon_clip.hpp"

namespace blockweir::openfoam {

constexpr double open_cells = 3;  ///< a gap that is wider carries all of its water in the mesh

/// Of an edge, as fractions of it.
struct EdgeInterval {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
};

struct EdgeElement {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
  Point from;
  Point to;
  Point normal;         ///< outwards
  double openness = 1;  ///< 0: the mesh carries no water here; 1: open
  bool slot = false;    ///< what the mesh does not carry stands in a gap that was there from the start: no crack
  double gap_m = std::numeric_limits<double>::infinity();  ///< to the face across
  [[nodiscard]] Point middle() const { return (from + to) / 2; }
};

/// Where a slot meets wider water, the way out of it, and how far that is.
struct SlotMouth {
  Point lip;    ///< its last point
  Point point;  ///< beyond, at most half a cell away
  Point direction;
  double distance_m = 0;
};

/// All edges as lines that are seen from their outer side.
class Faces {
 public:
  struct Hit {
    double distance_m = std::numeric_limits<double>::infinity();
    Point along = Point::Zero();  ///< of the face that is met, of length 1
  };
  explicit Faces(const std::vector<Polygon>& outlines);

  /// The nearest face that looks towards `from` along `direction` (of length 1), its own edge left out. Those of other
  /// blocks count as met up to `overlap_m` behind.
  [[nodiscard]] Hit nearest(const Point& from, const Point& direction, double reach_m, int block = -1, int edge = -1,
                            double overlap_m = 0) const;
  [[nodiscard]] const std::vector<Polygon>& outlines() const { return outlines_; }

 private:
  const std::vector<Polygon>& outlines_;
  std::vector<std::pair<Point, Point>> boxes_;
};

/// Rules by which edges are cut into elements.
struct ElementRules {
  double cell_m = 0;
  double open_crack_width_m = 0;     ///< gaps of no more between parallel faces carry no water
  std::vector<bool> loaded;          ///< by block
  std::vector<EdgeInterval> closed;  ///< in contact at the start: joints, whose cracks have laws of their own
  std::vector<EdgeInterval> cuts;    ///< elements end where these do
};

/// Parts of edges whose gap was closed when the blocks stood as in `outlines`.
std::vector<EdgeInterval> closed_intervals(const std::vector<Polygon>& outlines, ElementRules rules);

/// Elements end where a cell's length does, where a corner lies beside the edge, and where one of `cuts` does.
std::vector<EdgeElement> edge_elements(const Faces& faces, const ElementRules& rules);

/// Both ways out of the slot beside an element, followed in the middle between its faces; none at a dead end.
std::vector<SlotMouth> slot_mouths(const EdgeElement& element, const Faces& faces, double cell_m);

}  // namespace blockweir::openfoam
