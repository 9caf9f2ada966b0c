// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/site.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::openfoam {
namespace {

scene::Bounds bounds(const scene::Scene& scene) {
  scene::Bounds all = scene::bounds_of(scene.blocks.front().vertices);
  for (const scene::Block& block : scene.blocks) {
    const scene::Bounds one = scene::bounds_of(block.vertices);
    all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  }
  return all;
}

/// Of the times at which it is stated, and of what a sine adds.
double highest(const std::optional<scene::TimeTable>& level) {
  if (!level) return -std::numeric_limits<double>::infinity();
  return *std::max_element(level->value.begin(), level->value.end()) +
         (level->sine ? std::abs(level->sine->amplitude) : 0);
}

double highest_water(const scene::Scene& scene) {
  double level = std::max(highest(scene.water.upstream_level_m), highest(scene.water.downstream_level_m));
  for (const auto& outline : scene.openfoam.initial_water_m)
    level = std::max(level, scene::bounds_of(outline).high.y());
  return level;
}

/// Fixed blocks with a face on the model's left or right end whose top is under water are ground. Others, and what only
/// touches the end with its foot, are a wall.
std::vector<int> find_ground(const scene::Scene& scene, const scene::Bounds& model, double level_m) {
  std::vector<int> ground;
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (!scene.blocks[b].fixed) continue;
    double top = std::numeric_limits<double>::infinity();
    for (const double end : {model.low.x(), model.high.x()}) {
      double face_low = std::numeric_limits<double>::infinity();
      double face_top = -face_low;
      for (const scene::Point& p : scene.blocks[b].vertices) {
        if (p.x() != end) continue;
        face_low = std::min(face_low, p.y());
        face_top = std::max(face_top, p.y());
      }
      if (face_top > face_low) top = std::min(top, face_top);
    }
    if (top < level_m - 1e-9 * model.size()) ground.push_back(static_cast<int>(b));
  }
  return ground;
}

}  // namespace

bool Site::is_ground(std::size_t block) const {
  return std::find(ground.begin(), ground.end(), static_cast<int>(block)) != ground.end();
}

Site find_site(const scene::Scene& scene) {
  Site site;
  site.model = bounds(scene);
  site.highest_m = highest_water(scene);
  site.ground = find_ground(scene, site.model, site.highest_m);
  site.structure_left_m = site.model.high.x();
  site.structure_right_m = site.model.low.x();
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (site.is_ground(b)) continue;
    const scene::Bounds block = scene::bounds_of(scene.blocks[b].vertices);
    site.structure_left_m = std::min(site.structure_left_m, block.low.x());
    site.structure_right_m = std::max(site.structure_right_m, block.high.x());
  }
  return site;
}

std::vector<std::vector<scene::Point>> outlines_up_to(double left_m, double right_m, const Site& site,
                                                      const scene::Scene& scene) {
  std::vector<std::vector<scene::Point>> outlines;
  for (const scene::Block& block : scene.blocks) outlines.push_back(block.vertices);
  for (const int b : site.ground) {
    for (scene::Point& p : outlines[static_cast<std::size_t>(b)]) {
      if (p.x() == site.model.low.x()) p.x() = std::min(p.x(), left_m);
      if (p.x() == site.model.high.x()) p.x() = std::max(p.x(), right_m);
    }
  }
  return outlines;
}

}  // namespace blockweir::openfoam
