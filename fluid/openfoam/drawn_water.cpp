// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/drawn_water.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bridge/scene/diagnostic.hpp"
#include "fluid/openfoam/polygon_clip.hpp"

namespace blockweir::openfoam {
namespace {

constexpr double unnoticed = 1e-6;  // of the drawn water: an end that the scene states rounded

/// "upstream_depths = 3.2 or more", in units of which the last is the third figure, so that it suffices.
std::string at_least(const char* key, double depths) {
  const double unit = std::pow(10, std::floor(std::log10(depths)) - 2);
  return fmt::format("{} = {:.6g} or more", key, std::ceil(depths / unit - 1e-6) * unit);
}

/// The keys to change, each with the value that suffices.
std::string remedy(const scene::OpenFoam& o, const geometry::Bounds& drawn, const Grid& grid) {
  const double depth = grid.site.highest_m - grid.ground_m;
  std::string keys;
  const auto name = [&](const std::string& key) { keys += (keys.empty() ? "" : ", ") + key; };
  if (o.upstream_depths && drawn.low.x() < grid.x.front()) {
    name(at_least("upstream_depths", (grid.site.structure_left_m - drawn.low.x()) / depth));
  }
  if (o.downstream_depths && drawn.high.x() > grid.x.back()) {
    name(at_least("downstream_depths", (drawn.high.x() - grid.site.structure_right_m) / depth));
  }
  if (o.floor_m && drawn.low.y() < grid.y.front()) name(fmt::format("floor_m = {:.6g}", drawn.low.y()));
  return keys;
}

}  // namespace

std::optional<geometry::Bounds> bounds_of_drawn_water(const scene::Scene& scene) {
  std::vector<scene::Point> all;
  for (const auto& outline : scene.openfoam.initial_water_m) all.insert(all.end(), outline.begin(), outline.end());
  if (all.empty()) return std::nullopt;
  return geometry::bounds_of(all);
}

void require_drawn_water_inside(const scene::Scene& scene, const Grid& grid) {
  const auto drawn = bounds_of_drawn_water(scene);
  if (!drawn) return;
  const Polygon mesh{{grid.x.front(), grid.y.front()},
                     {grid.x.back(), grid.y.front()},
                     {grid.x.back(), grid.y.back()},
                     {grid.x.front(), grid.y.back()}};
  PolygonClip clip;
  double all_m2 = 0;
  double inside_m2 = 0;
  for (const auto& outline : scene.openfoam.initial_water_m) {
    all_m2 += area(outline);
    inside_m2 += clip.common_area(outline, mesh);
  }
  if (all_m2 - inside_m2 <= unnoticed * all_m2) return;
  const std::string keys = remedy(scene.openfoam, *drawn, grid);
  throw scene::SceneError(
      {{scene::Diagnostic::Severity::error, scene.file.string(), scene.openfoam.initial_water_line,
        fmt::format("{:.4g} of the {:.4g} m2 of water in initial_water_m lie outside OpenFOAM's mesh, which takes in "
                    "x = {:.5g} to {:.5g} m and y = {:.5g} to {:.5g} m",
                    all_m2 - inside_m2, all_m2, grid.x.front(), grid.x.back(), grid.y.front(), grid.y.back()),
        "a mesh that takes in all of the drawn water",
        fmt::format("state {} in [fluid], or leave {} out: the mesh then reaches as far as the drawn water", keys,
                    keys.find(',') == std::string::npos ? "this key" : "these keys")}});
}

}  // namespace blockweir::openfoam
