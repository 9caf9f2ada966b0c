// SPDX-License-Identifier: GPL-3.0-or-later
// A wall that holds a reservoir, for tests of its water.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

inline constexpr double rho = 1000;
inline constexpr double pi = std::numbers::pi;

/// A wall on the right of a reservoir `H` deep, cut at `cut_m` into two blocks, on ground that it shares.
struct Wall {
  double H = 20;
  double lean = 0;  ///< of its face, from the vertical: the foot lies upstream
  double cut_m = 0;
  std::optional<double> far_wall_m;

  [[nodiscard]] std::vector<std::vector<Point>> outlines() const {
    const auto face = [&](double y) { return -(H - y) * std::tan(lean); };
    const double top = 1.1 * H;
    const double bed = far_wall_m.value_or(-100);
    std::vector<std::vector<Point>> blocks{{{bed, -5}, {40, -5}, {40, 0}, {bed, 0}}};
    if (cut_m > 0) blocks.push_back({{face(0), 0}, {30, 0}, {30, cut_m}, {face(cut_m), cut_m}});
    blocks.push_back({{face(cut_m), cut_m}, {30, cut_m}, {30, top}, {face(top), top}});
    return blocks;
  }
};

inline WaterMesh mesh_of(const Wall& wall, double ratio, const FarEnd& left) {
  hydrostatic::Structure structure;
  structure.outlines = wall.outlines();
  structure.open_crack_width_m = 1e-3;
  structure.ground.left = scene::BedCorner{0, 3};
  hydrostatic::Pools pools;
  const auto water =
      pools.find(structure, wall.H, std::numeric_limits<double>::quiet_NaN(), scene::CrestPressure::none);
  return mesh_water(water.bodies.front(), {structure.outlines}, {left, {}}, {ratio, ratio / 100, 0.35});
}

inline std::ptrdiff_t node_nearest(const WaterMesh& mesh, const Point& x) {
  const auto nearest = std::min_element(mesh.node.begin(), mesh.node.end(), [&](const Point& a, const Point& b) {
    return (a - x).norm() < (b - x).norm();
  });
  return nearest - mesh.node.begin();
}

}  // namespace blockweir::reservoir
