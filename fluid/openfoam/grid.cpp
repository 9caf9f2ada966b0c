// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fluid/openfoam/drawn_water.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double widening = 1.1;         // from one column of the far field to the next
constexpr double open_depths = 2;        // beside the structure, where the scene does not state them
constexpr double uniform_depths = 0.25;  // of uniform cells beside the structure
constexpr std::size_t most_cells = 10'000'000;

/// The ground's underside is not where water goes: the lowest vertex above it.
double find_floor(const scene::Scene& scene, const geometry::Bounds& model, bool ground) {
  if (!ground) return model.low.y();
  double floor = model.high.y();
  for (const scene::Block& block : scene.blocks) {
    for (const scene::Point& p : block.vertices) {
      if (p.y() > model.low.y()) floor = std::min(floor, p.y());
    }
  }
  return floor;
}

/// Cells that start `first_m` wide and widen by about `widening`, over a length of exactly length_m.
Stretch widen(double length_m, double first_m) {
  const double n = std::log1p(length_m * (widening - 1) / first_m) / std::log(widening);
  const int cells = std::max(1, static_cast<int>(std::ceil(n)));
  const auto sum = [&](double r) { return std::abs(r - 1) < 1e-12 ? cells : (std::pow(r, cells) - 1) / (r - 1); };
  double low = 0.5;
  double high = widening + 1;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (first_m * sum(middle) < length_m ? low : high) = middle;
  }
  return {length_m, cells, std::pow((low + high) / 2, cells - 1)};
}

void append(std::vector<double>& lines, const Stretch& stretch) {
  const double start = lines.back();
  const double r = stretch.cells > 1 ? std::pow(stretch.expansion, 1.0 / (stretch.cells - 1)) : 1;
  const bool uniform = std::abs(r - 1) < 1e-12;
  for (int i = 1; i <= stretch.cells; ++i) {
    const double part =
        uniform ? static_cast<double>(i) / stretch.cells : (1 - std::pow(r, i)) / (1 - std::pow(r, stretch.cells));
    lines.push_back(start + part * stretch.length_m);
  }
}

}  // namespace

Grid make_grid(const scene::Scene& scene) {
  const scene::OpenFoam& o = scene.openfoam;
  Grid grid;
  grid.site = find_site(scene);
  const geometry::Bounds& model = grid.site.model;
  const double level = grid.site.highest_m;
  const double left = grid.site.structure_left_m;
  const double right = grid.site.structure_right_m;
  constexpr double far = std::numeric_limits<double>::infinity();
  const geometry::Bounds drawn = bounds_of_drawn_water(scene).value_or(geometry::Bounds{{far, far}, {-far, -far}});
  const double floor = o.floor_m.value_or(std::min(drawn.low.y(), find_floor(scene, model, !grid.site.ground.empty())));
  const double ground_top = std::max(floor, grid.site.bed_left_m);
  grid.downstream_ground_m = std::max(floor, grid.site.bed_right_m);
  const double depth = level - ground_top;
  if (depth <= 0) {
    throw std::invalid_argument(
        fmt::format("OpenFOAM: the highest level, {} m, lies below the ground, {} m; "
                    "expected water that reaches the structure",
                    level, ground_top));
  }
  const double h = depth / o.cells_in_depth;
  grid.cell_m = h;
  grid.ground_m = ground_top;
  const auto whole_cells = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / h - 1e-9))); };

  // Row lines meet the ground before the structure, column lines its upstream end.
  const int below = static_cast<int>(std::ceil((ground_top - floor) / h - 1e-9));
  const int above = whole_cells(std::max(level, model.high.y()) + o.freeboard_depths * depth - ground_top);
  for (int j = -below; j <= above; ++j) grid.y.push_back(ground_top + j * h);
  const double near = uniform_depths * depth;
  const int near_left = whole_cells(near);
  const int middle = near_left + whole_cells(right - left + near);
  const double left_end = left - near_left * h;
  const double right_end = left + (middle - near_left) * h;
  const double upstream =
      o.upstream_depths ? *o.upstream_depths * depth : std::max(open_depths * depth, left - drawn.low.x());
  const double downstream = o.downstream_depths ? *o.downstream_depths * depth
                                                : std::max(open_depths * depth, drawn.high.x() - right_end + near);
  const double far_left = std::max({h, upstream - near_left * h, left_end - grid.site.loose_left_m + h});
  const double far_right = std::max({h, downstream - near, grid.site.loose_right_m - right_end + h});
  Stretch narrowing = widen(far_left, h);
  narrowing.expansion = 1 / narrowing.expansion;
  if (o.wave) narrowing = {far_left, whole_cells(far_left), 1};  // wide cells would swallow it
  grid.stretches = {narrowing, {middle * h, middle, 1}, widen(far_right, h)};
  grid.x = {left - near_left * h - far_left};
  for (const Stretch& stretch : grid.stretches) append(grid.x, stretch);
  if (grid.cells() > most_cells) {
    throw std::invalid_argument(
        fmt::format("OpenFOAM: the mesh would have {} cells, at most {} are made; lower "
                    "cells_in_depth, upstream_depths or downstream_depths in [fluid]",
                    grid.cells(), most_cells));
  }
  require_drawn_water_inside(scene, grid);
  return grid;
}

std::vector<std::vector<scene::Point>> outlines_in(const Grid& grid, const scene::Scene& scene) {
  return outlines_up_to(grid.x.front() - grid.cell_m, grid.x.back() + grid.cell_m, grid.site, scene);
}

}  // namespace blockweir::openfoam
