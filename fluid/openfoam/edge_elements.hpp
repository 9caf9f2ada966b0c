// SPDX-License-Identifier: GPL-3.0-or-later
// Divides the blocks' edges into elements loaded by the water of one cell, and finds the parts that water reaches.
// C++17: the OpenFOAM plugin includes this.
#pragma once

#include <limits>

#include "fluid/openfoam/polygon_clip.hpp"

namespace blockweir::openfoam {

constexpr double open_cells = 3;  ///< a wider gap has all of its water in the mesh

/// Part of an edge, as fractions of it.
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
  double openness = 1;  ///< 0: no water of the mesh reaches it; 1: open
  bool slot = false;    ///< part of a gap too narrow for the mesh that existed at the start: not a crack
  double gap_m = std::numeric_limits<double>::infinity();  ///< to the opposite face
  [[nodiscard]] Point middle() const { return (from + to) / 2; }
};

/// The mouth of a slot (a narrow gap) at wider water, and the distance to it.
struct SlotMouth {
  Point lip;    ///< the slot's last point
  Point point;  ///< outside, at most half a cell away
  Point direction;
  double distance_m = 0;
};

/// All edges as lines that are visible from their outer side.
class Faces {
 public:
  struct Hit {
    double distance_m = std::numeric_limits<double>::infinity();
    Point along = Point::Zero();  ///< of the face that is hit, of length 1
  };
  explicit Faces(const std::vector<Polygon>& outlines);

  /// The nearest face visible from `from` in the unit `direction`, except the own edge. Faces of other blocks also
  /// count up to `overlap_m` behind `from`.
  [[nodiscard]] Hit nearest(const Point& from, const Point& direction, double reach_m, int block = -1, int edge = -1,
                            double overlap_m = 0) const;
  [[nodiscard]] const std::vector<Polygon>& outlines() const { return outlines_; }

 private:
  const std::vector<Polygon>& outlines_;
  std::vector<std::pair<Point, Point>> boxes_;
};

/// Rules for dividing edges into elements.
struct ElementRules {
  double cell_m = 0;
  double open_crack_width_m = 0;     ///< narrower gaps between parallel faces contain no water
  std::vector<bool> loaded;          ///< by block
  std::vector<EdgeInterval> closed;  ///< in contact at the start: joints, whose uplift follows their own laws
  std::vector<EdgeInterval> cuts;    ///< element ends that must be kept
};

/// Parts of edges whose gap is closed with these `outlines`.
std::vector<EdgeInterval> closed_intervals(const std::vector<Polygon>& outlines, ElementRules rules);

/// Elements end after the length of a cell, opposite corners, and at each of `cuts`.
std::vector<EdgeElement> edge_elements(const Faces& faces, const ElementRules& rules);

/// Both mouths of the slot beside an element, found along the middle between its faces; none at a dead end.
std::vector<SlotMouth> slot_mouths(const EdgeElement& element, const Faces& faces, double cell_m);

}  // namespace blockweir::openfoam
