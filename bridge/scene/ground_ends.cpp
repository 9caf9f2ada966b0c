// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/ground_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/viscous_ground.hpp"

namespace blockweir::scene {
namespace {

constexpr double no_height = std::numeric_limits<double>::infinity();

double highest_level(const std::optional<TimeTable>& level) {
  if (!level) return -no_height;
  return *std::max_element(level->value.begin(), level->value.end()) +
         (level->sine ? std::abs(level->sine->amplitude) : 0);
}

bool is_held(const Scene& scene, int block) {
  return scene.blocks[at(block)].fixed ||
         std::any_of(scene.supports.begin(), scene.supports.end(),
                     [&](const Support& s) { return s.block == block && s.displacement_y_m; }) ||
         rests_on_viscous_ground(scene, block);
}

/// An upright face on the model's end.
struct EndFace {
  double low_m;
  double high_m;
  BedCorner top;
};

std::vector<EndFace> faces_at(double end_m, const Scene& scene, double near_m) {
  std::vector<EndFace> faces;
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    const auto& outline = scene.blocks[b].vertices;
    for (std::size_t v = 0; v < outline.size(); ++v) {
      const std::size_t next = (v + 1) % outline.size();
      if (std::abs(outline[v].x() - end_m) > near_m || std::abs(outline[next].x() - end_m) > near_m) continue;
      const auto [low, high] = outline[v].y() < outline[next].y() ? std::pair(v, next) : std::pair(next, v);
      faces.push_back({outline[low].y(), outline[high].y(), {static_cast<int>(b), static_cast<int>(high)}});
    }
  }
  std::sort(faces.begin(), faces.end(), [](const EndFace& a, const EndFace& b) { return a.low_m < b.low_m; });
  return faces;
}

constexpr double bed_slope = 0.25;  // a part that rises more steeply from the bed's end is a structure

/// Distance from the end to the first structure on the bed.
double bed_length(double end_m, double bed_m, const Scene& scene, double near_m) {
  double length = no_height;
  for (const Block& block : scene.blocks) {
    for (std::size_t v = 0; v < block.vertices.size(); ++v) {
      const Point& a = block.vertices[v];
      const Point& b = block.vertices[(v + 1) % block.vertices.size()];
      const double a_m = std::abs(a.x() - end_m);
      const double b_m = std::abs(b.x() - end_m);
      const double a_above = a.y() - bed_m - bed_slope * a_m;
      const double b_above = b.y() - bed_m - bed_slope * b_m;
      if (a_above > near_m) length = std::min(length, a_m);
      if ((a_above > near_m) != (b_above > near_m)) {
        length = std::min(length, a_m + (b_m - a_m) * a_above / (a_above - b_above));
      }
    }
  }
  return length;
}

}  // namespace

GroundEnds find_ground_ends(const Scene& scene) {
  const std::optional<bool> wets_ends = scene.water.wets_ends;
  if (scene.blocks.empty() || wets_ends.value_or(false)) return {};
  const geometry::Bounds model = bounds_of(scene);
  const double near = 1e-6 * model.size();
  const double dry = std::min(model.high.y(), std::max(highest_level(scene.water.upstream_level_m),
                                                       highest_level(scene.water.downstream_level_m)));
  const auto ground_at = [&](double end_m) -> std::optional<BedCorner> {
    const std::vector<EndFace> faces = faces_at(end_m, scene, near);
    if (faces.empty()) return std::nullopt;
    EndFace column = faces.front();
    for (const EndFace& face : faces) {
      if (face.low_m > column.high_m + near) break;
      if (face.high_m > column.high_m) column = {column.low_m, face.high_m, face.top};
    }
    if (column.high_m > dry - near) return std::nullopt;
    const bool is_ground = is_held(scene, faces.front().top.block) &&
                           bed_length(end_m, column.high_m, scene, near) >= (column.high_m - column.low_m) / 2;
    return is_ground || wets_ends ? std::optional(column.top) : std::nullopt;
  };
  return {ground_at(model.low.x()), ground_at(model.high.x())};
}

bool lowest_floats(const Scene& scene) {
  const auto height = [](const Block& block) { return geometry::bounds_of(block.vertices).low.y(); };
  const auto lowest = std::min_element(scene.blocks.begin(), scene.blocks.end(),
                                       [&](const auto& a, const auto& b) { return height(a) < height(b); });
  if (lowest == scene.blocks.end() || is_held(scene, static_cast<int>(lowest - scene.blocks.begin()))) return false;
  return scene.materials[at(lowest->material)].density_kg_per_m3 < scene.water.density_kg_per_m3;
}

}  // namespace blockweir::scene
