// SPDX-License-Identifier: GPL-3.0-or-later
// Where in the mesh the water that touches a point of an edge is looked up: in a cell that no block reaches and that
// the point sees. C++17: the OpenFOAM plugin includes this.
#pragma once

#include <array>
#include <functional>

#include "fluid/openfoam/edge_elements.hpp"

namespace blockweir::openfoam {

constexpr double untouched = 1e-6;   ///< share of a cell that a block may fill where the cell still counts as open
constexpr double sealed = 1 - 1e-6;  ///< share at which it has no water
constexpr double all_water = 0.99;   ///< volume fraction from which a cell counts as full of water

/// A place that looks for its water, and which ways it does: the first is the best, others help where that is blocked.
struct SampleRay {
  Point from;
  std::vector<Point> directions;  ///< of length 1
  int block = -1;                 ///< whose edge it stands on
  int edge = -1;
};

/// Along the axis nearer to the normal: the cell beside a sloping face is then as deep as the face, and next to a steep
/// one it is under water if that is. Then, for corners, the normal and the ways in between.
SampleRay ray_of(const EdgeElement& element);
/// Outwards of a crack's mouth or a slot's.
SampleRay ray_at(const Point& mouth, const Point& direction);

/// Points half a cell apart, nearest first.
struct SamplePoints {
  static constexpr int most = 8;
  std::array<Point, most> at;
  int count = 0;
  bool cut = false;  ///< no open cell is in sight: the only point lies in the one that blocks fill least
};

/// Share that blocks fill of the cells at these points; 1 where there is no cell.
using Fills = std::function<std::vector<double>(const std::vector<Point>&)>;

/// Nothing (count 0) where all cells in sight are full.
std::vector<SamplePoints> find_sample_points(const std::vector<SampleRay>& rays, const Faces& faces, double cell_m,
                                             const Fills& fills);

/// A slot's mouth from which open cells are in sight.
struct Mouth {
  std::size_t samples = 0;
  SlotMouth place;
};

/// All that has to be looked up for the edges where they are now.
struct Targets {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<EdgeElement> elements;
  std::vector<SamplePoints> samples;
  std::vector<std::size_t> samples_of;     ///< of each element; none: the mesh carries no water to it
  std::vector<std::vector<Mouth>> mouths;  ///< by element; empty but for slots
  std::size_t openings_from = 0;           ///< samples of `openings`, in their order
};

Targets find_targets(const Faces& faces, const ElementRules& rules, const std::vector<SampleRay>& openings,
                     const Fills& fills);

}  // namespace blockweir::openfoam
