// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/voronoi_cells.hpp"

namespace blockweir::independent {
namespace {

/// What of a convex polygon is nearer to `own` than to `other`.
std::vector<Vec> nearer(const std::vector<Vec>& polygon, const Vec& own, const Vec& other) {
  const Vec apart = other - own;
  const auto beyond = [&](const Vec& p) { return apart.dot(p - (own + other) / 2); };
  std::vector<Vec> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec& p = polygon[i];
    const Vec& q = polygon[(i + 1) % polygon.size()];
    const double at_p = beyond(p);
    const double at_q = beyond(q);
    if (at_p <= 0) kept.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

}  // namespace

std::vector<std::vector<Vec>> voronoi_cells(const std::vector<Vec>& outline, const std::vector<Vec>& points,
                                            double shortest_m) {
  std::vector<std::vector<Vec>> cells;
  for (const Vec& own : points) {
    std::vector<Vec> cell = outline;
    for (const Vec& other : points) {
      if (&other != &own) cell = nearer(cell, own, other);
    }
    for (std::size_t i = 0; i < cell.size(); ++i) {
      if ((cell[(i + 1) % cell.size()] - cell[i]).norm() < shortest_m) return {};
    }
    if (cell.size() >= 3) cells.push_back(std::move(cell));
  }
  return cells;
}

}  // namespace blockweir::independent
