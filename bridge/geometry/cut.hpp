// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a section into blocks along lines, exactly: an arrangement of segments with rational coordinates.
#pragma once

#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::geometry {

struct Section {
  std::vector<Point> outline;
  std::vector<std::vector<Point>> holes;
};

/// A polyline that cuts the section. Edges along it carry its `id`, 0 or more.
struct Line {
  std::vector<Point> points;
  int id = 0;
};

/// A block: counter-clockwise, without vertices inside straight sides.
struct Piece {
  std::vector<Point> vertices;
};

/// Two pieces that share a boundary along a line.
struct Neighbours {
  int a = 0;  ///< indices of pieces, a < b
  int b = 0;
  int id = 0;  ///< of the line along the longest part of their boundary; the smallest id where lines coincide
};

struct Cut {
  std::vector<Piece> pieces;  ///< sorted by their lowest corner, then from left to right
  std::vector<Neighbours> neighbours;
  double dangling_m = 0;  ///< length of cuts that end inside a block and so separate nothing
  /// A corner of each closed line or hole that lies inside a block and touches its sides nowhere or in this point only.
  std::vector<Point> enclosed;
};

/// Pieces thinner than 1e-8 of the section's size are merged with a neighbour. Parts of lines outside the section are
/// ignored, and dangling ends are removed. Coordinates are rounded once, at the end, in the same way for all pieces
/// that share a point. Pieces that enclose another are left out and reported in `enclosed`.
Cut cut(const Section& section, const std::vector<Line>& lines);

}  // namespace blockweir::geometry
