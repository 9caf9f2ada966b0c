// SPDX-License-Identifier: GPL-3.0-or-later
// Points where the water at an edge is sampled: in a cell that no block reaches and that is visible from the edge.
// C++17: the OpenFOAM plugin includes this.
#pragma once

#include <array>
#include <functional>

#include "fluid/openfoam/edge_elements.hpp"

namespace blockweir::openfoam {

constexpr double untouched = 1e-6;   ///< largest filled share of an open cell
constexpr double sealed = 1 - 1e-6;  ///< filled share from which a cell has no water
constexpr double all_water = 0.99;   ///< volume fraction from which a cell counts as full of water

/// A point whose water is sampled, and the directions to search: the first is preferred, others help if it is blocked.
struct SampleRay {
  Point from;
  std::vector<Point> directions;  ///< of length 1
  int block = -1;                 ///< block of its edge
  int edge = -1;
};

/// First along the axis nearest to the normal: the cell beside a sloping face is then at the face's depth, and beside a
/// steep face it is under water if the face is. Then, for corners, the normal and directions in between.
SampleRay ray_of(const EdgeElement& element);
/// Outwards from the mouth of a crack or slot.
SampleRay ray_at(const Point& mouth, const Point& direction);

/// Points half a cell apart, nearest first.
struct SamplePoints {
  static constexpr int most = 8;
  std::array<Point, most> at;
  int count = 0;
  bool cut = false;  ///< no open cell is in sight: the only point is in the least filled cell
};

/// Filled share of the cells at these points; 1 outside the mesh.
using Fills = std::function<std::vector<double>(const std::vector<Point>&)>;

/// No points (count 0) if all cells in sight are full.
std::vector<SamplePoints> find_sample_points(const std::vector<SampleRay>& rays, const Faces& faces, double cell_m,
                                             const Fills& fills);

/// A slot's mouth with open cells in sight.
struct Mouth {
  std::size_t samples = 0;
  SlotMouth place;
};

/// All sample points for the edges at their present positions.
struct Targets {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<EdgeElement> elements;
  std::vector<SamplePoints> samples;
  std::vector<std::size_t> samples_of;     ///< of each element; none: no water of the mesh reaches it
  std::vector<std::vector<Mouth>> mouths;  ///< by element; empty except for slots
  std::size_t openings_from = 0;           ///< first sample of `openings`, which follow in their order
};

Targets find_targets(const Faces& faces, const ElementRules& rules, const std::vector<SampleRay>& openings,
                     const Fills& fills);

}  // namespace blockweir::openfoam
