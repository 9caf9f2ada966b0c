// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the size of the structure with its ground and water: very different sizes suggest another unit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/read/magnitudes.hpp"

namespace blockweir::scene {
namespace {

constexpr const char* in_metres = "are some coordinates in centimetres or millimetres? write metres";

/// Bounding box of the moving blocks, or of the fixed ones.
std::optional<geometry::Bounds> box_of(const std::vector<Block>& blocks, bool fixed) {
  std::vector<Point> points;
  for (const Block& block : blocks) {
    if (block.fixed == fixed) points.insert(points.end(), block.vertices.begin(), block.vertices.end());
  }
  if (points.empty()) return std::nullopt;
  return geometry::bounds_of(points);
}

void check_ground(const Scene& scene, const geometry::Bounds& structure, Problems& problems) {
  constexpr double most = 20;  // a cantilever is far longer than what holds it
  const auto ground = box_of(scene.blocks, /*fixed=*/true);
  if (!ground) return;
  const double width_m = structure.high.x() - structure.low.x();
  const double ground_m = ground->high.x() - ground->low.x();
  if (width_m <= most * ground_m) return;
  problems.warning(
      problems.at(scene.blocks.front().line),
      fmt::format("what can move is {:.4g} m wide, and the fixed blocks {:.4g} m, which is unusual", width_m, ground_m),
      fmt::format("at most {:g} times the width of the fixed blocks", most), in_metres);
}

void check_depth(const toml::table& file, const Scene& scene, const geometry::Bounds& structure, Problems& problems) {
  constexpr double least = 0.015;
  if (!still_pools(scene.fluid) || !scene.water.upstream_level_m) return;
  const TimeTable& level = *scene.water.upstream_level_m;
  double highest = level.rows_at(0);
  for (std::size_t row = 0; row < level.time_s.size(); ++row) highest = std::max(highest, level.value[row]);
  if (level.sine) highest += std::abs(level.sine->amplitude);
  const double height_m = structure.high.y() - structure.low.y();
  const double depth_m = highest - structure.low.y();
  if (depth_m <= 0 || depth_m >= least * height_m) return;  // below its foot: told elsewhere
  problems.warning(problems.at(file["water"]["upstream_level_m"].node()->source()),
                   fmt::format("upstream_level_m rises to {:.4g} m above the foot of what can move, which is {:.4g} m "
                               "high: {:.2g} % of it, which is unusual",
                               depth_m, height_m, 100 * depth_m / height_m),
                   fmt::format("at least {:g} %", 100 * least), in_metres);
}

}  // namespace

void check_proportions(const toml::table& file, const Scene& scene, Problems& problems) {
  const auto structure = box_of(scene.blocks, /*fixed=*/false);
  if (!structure) return;
  check_ground(scene, *structure, problems);
  check_depth(file, scene, *structure, problems);
}

}  // namespace blockweir::scene
