// SPDX-License-Identifier: GPL-3.0-or-later
// Structures in still water, and the forces on them: by their exact shapes, and as the mesh's cells at time 0 give
// them.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/read/read.hpp"
#include "fluid/openfoam/initial_water.hpp"
#include "fluid/openfoam/pool_cells.hpp"
#include "fluid/openfoam/resolution.hpp"
#include "fluid/openfoam/sample_points.hpp"

namespace blockweir::openfoam::shapes {

using Blocks = std::vector<std::pair<std::string, Polygon>>;
constexpr double weight = 9810;  // N/m3

inline scene::Scene scene_of(const Blocks& blocks, double upstream_m, double downstream_m, int cells_in_depth) {
  std::string text =
      "[analysis]\nduration_s = 1\n[material.stone]\nyoungs_modulus_pa = 5e10\npoissons_ratio = 0.2\n"
      "density_kg_per_m3 = 2500\n[joint]\nfriction_angle_deg = 30\n[[block]]\nname = \"ground\"\nmaterial = \"stone\"\n"
      "fixed = true\nvertices_m = [[-20, -3], [40, -3], [40, 0], [-20, 0]]\n";
  for (const auto& [name, outline] : blocks) {
    text += "[[block]]\nname = \"" + name + "\"\nmaterial = \"stone\"\nfixed = true\nvertices_m = [";
    for (const Point& p : outline) text += "[" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + "], ";
    text += "]\n";
  }
  // Of a size of its own, as the structure's is the whole model's where nothing can move.
  text +=
      "[water]\nmay_overtop = true\nopen_crack_width_m = 0.05\nupstream_level_m = " + std::to_string(upstream_m) + "\n";
  if (downstream_m > 0) text += "downstream_level_m = " + std::to_string(downstream_m) + "\n";
  text += "[fluid]\nmodel = \"openfoam\"\nupstream_depths = 0.5\ndownstream_depths = 0.5\ncells_in_depth = " +
          std::to_string(cells_in_depth) + "\n";
  return scene::read_text(text, "shapes.toml").scene;
}

/// On one block, per metre of thickness.
struct Force {
  Point sum = Point::Zero();
  double gross = 0;
  /// Of water at rest with that depth at the ends of a piece of an edge, whose normal looks outwards.
  void press(const Point& from, const Point& to, const Point& normal, double level_m, double share = 1) {
    const double at_from = level_m - from.y();
    const double at_to = level_m - to.y();
    const double wet = at_from * at_to < 0 ? std::max(at_from, at_to) / std::abs(at_from - at_to) : 1;
    const double force =
        share * weight * wet * (std::max(0.0, at_from) + std::max(0.0, at_to)) / 2 * (to - from).norm();
    sum -= force * normal;
    gross += force;
  }
};

inline std::vector<Force> exact_forces(const scene::Scene& scene, const Grid& grid) {
  const auto outlines = outlines_in(grid, scene);
  std::vector<Force> forces(outlines.size());
  for (const ExactPool& pool : exact_pools(scene, grid, outlines)) {
    for (const auto& w : pool.faces.intervals) {
      const auto b = static_cast<std::size_t>(w.block);
      if (grid.site.is_ground(b)) continue;
      const Polygon& outline = outlines[b];
      const Point& from = outline[static_cast<std::size_t>(w.edge)];
      const Point span = outline[(static_cast<std::size_t>(w.edge) + 1) % outline.size()] - from;
      const Point normal = Point(span.y(), -span.x()).normalized();
      forces[b].press(from + w.s_from * span, from + w.s_to * span, normal, pool.level_m);
    }
  }
  return forces;
}

/// Level of the pool that the cell at a point holds at time 0, or one of the two cells below it, as the plugin looks.
class MeshedPools {
 public:
  MeshedPools(const scene::Scene& scene, const Grid& grid) : grid_(grid), levels_(levels_at_start(scene)) {
    const auto outlines = outlines_in(grid, scene);
    filled_ = filled_cells(grid, outlines);
    holds_ = pool_cells(grid, scene, filled_, exact_pools(scene, grid, outlines));
  }
  /// Beyond the mesh nothing is seen, as in a full cell.
  [[nodiscard]] double fill(const Point& p) const { return holds_point(p) ? filled_[cell(p)] : 1; }
  [[nodiscard]] double level_m(Point p) const {
    for (int down = 0; down < 3; ++down, p.y() -= grid_.cell_m) {
      if (!holds_point(p)) break;
      constexpr double deep_cut = 0.95;  // as in water_state.cpp
      if (down > 0 && filled_[cell(p)] > deep_cut) break;
      const Holds holds = holds_[cell(p)];
      if (holds == Holds::upstream) return levels_.upstream_m;
      if (holds == Holds::downstream) return levels_.downstream_m;
    }
    return -1e9;
  }

 private:
  [[nodiscard]] bool holds_point(const Point& p) const {
    return p.x() >= grid_.x.front() && p.x() < grid_.x.back() && p.y() >= grid_.y.front() && p.y() < grid_.y.back();
  }
  [[nodiscard]] std::size_t cell(const Point& p) const {
    const auto line = [](const std::vector<double>& lines, double v) {
      return static_cast<std::size_t>(std::upper_bound(lines.begin(), lines.end(), v) - lines.begin() - 1);
    };
    return line(grid_.y, p.y()) * grid_.columns() + line(grid_.x, p.x());
  }
  const Grid& grid_;
  PoolLevels levels_;
  std::vector<double> filled_;
  std::vector<Holds> holds_;
};

inline std::vector<Force> meshed_forces(const scene::Scene& scene, const Grid& grid) {
  const auto outlines = outlines_in(grid, scene);
  ElementRules rules;
  rules.cell_m = grid.cell_m;
  rules.open_crack_width_m = scene.water.open_crack_width_m;
  for (std::size_t b = 0; b < outlines.size(); ++b) rules.loaded.push_back(!grid.site.is_ground(b));
  rules.closed = closed_intervals(outlines, rules);
  const MeshedPools pools(scene, grid);
  const Targets targets = find_targets(Faces(outlines), rules, {}, [&](const std::vector<Point>& points) {
    std::vector<double> fills;
    for (const Point& p : points) fills.push_back(pools.fill(p));
    return fills;
  });
  const auto level_seen = [&](std::size_t samples) {
    const SamplePoints& l = targets.samples[samples];
    for (int k = 0; k < l.count; ++k) {
      const Point& at = l.at[static_cast<std::size_t>(k)];
      if (l.cut || pools.fill(at) <= untouched) return pools.level_m(at);
    }
    return -1e9;
  };
  std::vector<Force> forces(outlines.size());
  for (std::size_t i = 0; i < targets.elements.size(); ++i) {
    const EdgeElement& e = targets.elements[i];
    Force& force = forces[static_cast<std::size_t>(e.block)];
    if (e.openness > 0) force.press(e.from, e.to, e.normal, level_seen(targets.samples_of[i]), e.openness);
    for (const Mouth& mouth : targets.mouths[i]) {
      const double level = level_seen(mouth.samples);
      if (level <= mouth.place.lip.y()) continue;
      force.press(e.from, e.to, e.normal, level, 1 - e.openness);
      break;
    }
  }
  return forces;
}

}  // namespace blockweir::openfoam::shapes
