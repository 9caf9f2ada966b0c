// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/mesh_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/polygon.hpp"

namespace blockweir::scene {

void read_mesh_size(TableReader& table, Reading& reading, const char* stiff, std::span<const Point> outline,
                    double& size_m) {
  constexpr double most_triangles = 20000;
  if (!table.number("mesh_size_m", size_m, positive())) return;
  if (stiff != nullptr) {
    reading.problems.error(table.place("mesh_size_m"),
                           fmt::format("{} is {} and has a mesh_size_m", table.name(), stiff),
                           "mesh_size_m where something can strain", "leave out one of the two");
  }
  if (outline.empty()) return;
  // Triangles of a refined mesh have about half the area of one with three sides of that size.
  // Along the boundary, which may be all of a slender block, there is one for each length.
  double perimeter = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) perimeter += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  const double triangles =
      std::max(std::abs(geometry::signed_area(outline)) / (0.2 * size_m * size_m), perimeter / size_m);
  if (triangles <= most_triangles) return;
  reading.problems.error(
      table.place("mesh_size_m"),
      fmt::format("a mesh of {} m would cut {} into about {:.2g} triangles", size_m, table.name(), triangles),
      fmt::format("at most {}", most_triangles), "make mesh_size_m larger");
}

}  // namespace blockweir::scene
