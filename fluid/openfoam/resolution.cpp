// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bridge/scene/hydrostatics.hpp"
#include "fluid/openfoam/exact_pools.hpp"
#include "fluid/openfoam/pool_cells.hpp"
#include "fluid/openfoam/sample_points.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double told = 1e-3;  // of the force on a block: less is no matter
constexpr double refused = 1e-2;
constexpr double open_cell = 0.5;  // filled less, a cell is not wall
/// Flow resistance of the water in front of a leaking cell, relative to a free cell: measured on walls of 0.5 to 1 m
/// that retain 10 m of water, in cells of 0.5 m, whose force is 92 to 66 % too small.
constexpr double water_resistance = 1.3;

long cell_of(const Grid& g, const Point& p) {
  const auto line = [](const std::vector<double>& lines, double v) {
    return std::upper_bound(lines.begin(), lines.end(), v) - lines.begin() - 1;
  };
  const long i = line(g.x, p.x());
  const long j = line(g.y, p.y());
  const bool inside = i >= 0 && j >= 0 && i < static_cast<long>(g.columns()) && j < static_cast<long>(g.rows());
  return inside ? j * static_cast<long>(g.columns()) + i : -1;
}

/// Fraction of the element that open water reaches.
double wet_share(const EdgeElement& e, const std::vector<hydrostatic::WetInterval>& wet) {
  double share = 0;
  for (const hydrostatic::WetInterval& w : wet) {
    if (w.block != e.block || w.edge != e.edge) continue;
    share += std::max(0.0, std::min(w.s_to, e.s_to) - std::max(w.s_from, e.s_from));
  }
  return share / (e.s_to - e.s_from);
}

/// What is behind an element: the wall's resistance relative to a free cell, and the first point beyond it.
struct Wall {
  double resistance = 0;
  Point beyond;
};

/// Along the mesh axis nearest to the normal. interFoam averages the permeability of two cells at their common face, so
/// that two full cells side by side are tight. None: the wall is at least that thick.
std::optional<Wall> thin_wall(const EdgeElement& e, const Grid& grid, const std::vector<double>& filled,
                              const std::vector<Polygon>& outlines) {
  constexpr double tight = 1e-3;
  const bool across = std::abs(e.normal.x()) >= std::abs(e.normal.y());
  const Point inwards = across ? Point(-std::copysign(1, e.normal.x()), 0) : Point(0, -std::copysign(1, e.normal.y()));
  const auto fill = [&](const Point& p) {
    const long cell = cell_of(grid, p);
    return cell < 0 ? 1 : std::min(1.0, filled[static_cast<std::size_t>(cell)]);
  };
  Wall wall{0, e.middle() - grid.cell_m * inwards};
  double before = fill(wall.beyond);
  for (;;) {
    wall.beyond += grid.cell_m * inwards;
    const double here = fill(wall.beyond);
    const double passes = 1 - (before + here) / 2;
    if (passes < tight) return std::nullopt;
    if (before > 0 || here > 0) wall.resistance += 1 / passes;
    const bool inside = (wall.beyond - e.middle()).dot(inwards) <= 0 || within(outlines, wall.beyond);
    if (!inside && here <= open_cell) return wall;
    before = here;
  }
}

/// Forces on one block [N/m].
struct Forces {
  double gross = 0;
  double unreached = 0;
  double leak_length = 0;
  std::vector<std::pair<double, double>> leaks;  ///< force that a wall holds, and its resistance
  Point at;
  double largest = 0;

  void note(double force, const Point& where) {
    if (force <= largest) return;
    largest = force;
    at = where;
  }
  [[nodiscard]] double leaked(double cell_m) const {
    const double water = water_resistance * std::max(1.0, leak_length / cell_m);
    double force = 0;
    for (const auto& [held, resistance] : leaks) force += held * water / (water + resistance);
    return force;
  }
};

/// Number of cells needed, by trial; none: no mesh of reasonable size is enough.
std::optional<int> cells_needed(scene::Scene scene) {
  constexpr std::size_t tried_cells = 500'000;
  for (;;) {
    scene.openfoam.cells_in_depth += std::max(1, scene.openfoam.cells_in_depth / 4);
    const Grid grid = make_grid(scene);
    if (grid.cells() > tried_cells) return std::nullopt;
    const auto left = misfits(scene, grid);
    if (std::none_of(left.begin(), left.end(), [](const Misfit& m) { return m.share > refused; })) {
      return scene.openfoam.cells_in_depth;
    }
  }
}

std::string text_of(const Misfit& m, const scene::Scene& scene, const Grid& grid) {
  return fmt::format(
      "OpenFOAM: cells of {:.4g} m do not resolve block \"{}\" at ({:.4g}, {:.4g}) m: {}, and {:.3g} % of the force of "
      "still water on it would be wrong",
      grid.cell_m, scene.blocks[static_cast<std::size_t>(m.block)].name, m.at.x(), m.at.y(),
      m.leaks ? "water would go through it" : "no water in the mesh reaches its wet face", 100 * m.share);
}

}  // namespace

std::vector<Misfit> misfits(const scene::Scene& scene, const Grid& grid) {
  const std::vector<Polygon> outlines = outlines_in(grid, scene);
  const std::vector<double> filled = filled_cells(grid, outlines);
  ElementRules rules;
  rules.cell_m = grid.cell_m;
  rules.open_crack_width_m = scene.water.open_crack_width_m;
  for (std::size_t b = 0; b < outlines.size(); ++b) rules.loaded.push_back(!grid.site.is_ground(b));
  rules.closed = closed_intervals(outlines, rules);
  const Faces faces(outlines);
  const Targets targets = find_targets(faces, rules, {}, [&](const std::vector<Point>& points) {
    std::vector<double> fills;
    for (const Point& p : points) {
      const long cell = cell_of(grid, p);
      fills.push_back(cell < 0 ? 1 : filled[static_cast<std::size_t>(cell)]);
    }
    return fills;
  });
  const std::vector<ExactPool> pools = exact_pools(scene, grid, outlines);
  const double weight = scene::unit_weight_of_water(scene);
  std::vector<Forces> forces(outlines.size());
  for (std::size_t i = 0; i < targets.elements.size(); ++i) {
    const EdgeElement& e = targets.elements[i];
    const bool looked = e.openness > 0 && targets.samples[targets.samples_of[i]].count > 0;
    const double length = (e.to - e.from).norm();
    double pressure = 0;
    for (const ExactPool& pool : pools) {
      pressure = std::max(pressure, wet_share(e, pool.faces.intervals) * weight * pool.depth(e.middle()));
    }
    if (pressure == 0) continue;
    Forces& f = forces[static_cast<std::size_t>(e.block)];
    f.gross += pressure * length;
    // A gap's own share of the element is pressed from its mouths, the rest by the cells in sight.
    const bool entered = !e.slot || !targets.mouths[i].empty();
    const double dry = (entered ? 0 : 1 - e.openness) + (looked ? 0 : e.openness);
    f.unreached += dry * pressure * length;
    if (dry > 0) f.note(dry * pressure * length, e.middle());
    const std::optional<Wall> wall = thin_wall(e, grid, filled, outlines);
    if (!wall) continue;
    // Air beyond holds back water that would have to rise to it.
    double behind = weight * std::max(0.0, wall->beyond.y() - e.middle().y());
    for (const ExactPool& pool : pools) {
      if (pool.holds(wall->beyond)) behind = std::max(behind, weight * pool.depth(e.middle()));
    }
    if (pressure <= behind) continue;
    f.leak_length += length;
    f.leaks.emplace_back((pressure - behind) * length, wall->resistance);
    f.note((pressure - behind) * length, e.middle());
  }
  std::vector<Misfit> all;
  for (std::size_t b = 0; b < forces.size(); ++b) {
    const Forces& f = forces[b];
    const double leaked = f.leaked(grid.cell_m);
    const double share = f.gross > 0 ? (f.unreached + leaked) / f.gross : 0;
    if (share > told) all.push_back({static_cast<int>(b), f.at, share, leaked > f.unreached});
  }
  return all;
}

std::vector<std::string> check_resolution(const scene::Scene& scene, const Grid& grid) {
  std::vector<std::string> lines;
  for (const Misfit& m : misfits(scene, grid)) {
    const std::string text = text_of(m, scene, grid);
    if (m.share <= refused) {
      lines.push_back(text);
      continue;
    }
    const std::optional<int> cells = cells_needed(scene);
    throw std::invalid_argument(text +
                                (cells ? fmt::format("; raise cells_in_depth in [fluid] to {}", *cells)
                                       : "; no mesh of up to 500,000 cells does: make it thicker, the gap wider, or "
                                         "use model = \"hydrostatic\""));
  }
  return lines;
}

}  // namespace blockweir::openfoam
