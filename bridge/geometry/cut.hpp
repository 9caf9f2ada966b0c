// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a section by lines into blocks, exactly: an arrangement of segments with rational coordinates.
#pragma once

#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

struct Section {
  std::vector<Point> outline;
  std::vector<std::vector<Point>> holes;
};

/// A polyline that cuts. `id` is what edges along it carry, 0 or more.
struct Line {
  std::vector<Point> points;
  int id = 0;
};

/// A block: counter-clockwise, without corners on straight lines.
struct Piece {
  std::vector<Point> vertices;
};

/// Two pieces with a common boundary along a line.
struct Neighbours {
  int a = 0;  ///< indices of pieces, a < b
  int b = 0;
  int id = 0;  ///< of the line along the longest part of their boundary; the smallest where lines lie on each other
};

struct Cut {
  std::vector<Piece> pieces;  ///< by their lowest corner, of equals the leftmost
  std::vector<Neighbours> neighbours;
  double dangling_m = 0;  ///< length of cuts inside the section that end in a block, and so part nothing
  /// A corner of each closed line or hole that lies in a block and touches none of its sides, or only in this point.
  std::vector<Point> enclosed;
};

/// What would be thinner than 1e-8 of the section's size joins a neighbour.
/// Parts of lines outside the section are ignored, dangling ones removed. Coordinates are rounded once, at the end, the
/// same for all pieces that meet in a point. Pieces that enclose something are left out and told by `enclosed`.
Cut cut(const Section& section, const std::vector<Line>& lines);

}  // namespace blockweir::geometry
