// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratic triangles of a body of water, fine at its corners, and what each side of its boundary is.
#pragma once

#include <array>
#include <vector>

#include "fluid/reservoir/water_region.hpp"

namespace blockweir::reservoir {

/// A side of a triangle on the water's boundary: its end nodes and the one between them, water on the left.
struct BoundarySide {
  enum class Kind { face, bed, surface, far_end };
  Kind kind = Kind::bed;
  std::array<int, 3> node{};  ///< from, middle, to
  int block = -1;             ///< whose face it lies on
  int edge = -1;
  double s_from = 0;  ///< fractions 0..1 along the edge, of the side's ends
  double s_to = 0;
};

/// Corners first, then middles: 0, 1, 2, middle of 01, of 12, of 20.
using QuadraticTriangle = std::array<int, 6>;

/// How fine a mesh is, in parts of the water's depth.
struct Fineness {
  double widest = 0.25;  ///< side of a triangle, at most
  double at_corner = 0;  ///< side of a triangle at a corner of the water
  double growth = 0.35;  ///< by how much sides grow with the distance from the nearest corner
};

struct WaterMesh {
  std::vector<Point> node;
  std::vector<QuadraticTriangle> triangle;  ///< counter-clockwise
  std::vector<BoundarySide> side;
  std::vector<Ring> rings;  ///< the boundary: sides begin and end at its points
  FarEnds ends;
  double depth_m = 0;
};

/// Delaunay refinement (Ruppert, Shewchuk) of the body's region, whose ends in open water are moved to `ends`. Empty
/// for a body without a region.
WaterMesh mesh_water(const hydrostatic::WaterBody& body, const Banks& banks, const FarEnds& ends,
                     const Fineness& fineness);

}  // namespace blockweir::reservoir
