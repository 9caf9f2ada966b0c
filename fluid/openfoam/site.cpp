// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/site.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/ground_ends.hpp"

namespace blockweir::openfoam {
namespace {

/// Of the times at which it is stated, and of what a sine adds.
double highest(const std::optional<scene::TimeTable>& level) {
  if (!level) return -std::numeric_limits<double>::infinity();
  return *std::max_element(level->value.begin(), level->value.end()) +
         (level->sine ? std::abs(level->sine->amplitude) : 0);
}

double highest_water(const scene::Scene& scene) {
  double level = std::max(highest(scene.water.upstream_level_m), highest(scene.water.downstream_level_m));
  for (const auto& outline : scene.openfoam.initial_water_m)
    level = std::max(level, geometry::bounds_of(outline).high.y());
  return level;
}

/// Fixed blocks with a face on the model's left or right end and their top under water are ground. Others, and blocks
/// that touch the end at their foot only, are a wall.
std::vector<int> find_ground(const scene::Scene& scene, const geometry::Bounds& model, double level_m) {
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

/// How high a block is on an end of the model; minus infinity where it does not reach that.
double top_at(double end_m, const scene::Block& block) {
  double top = -std::numeric_limits<double>::infinity();
  for (const scene::Point& p : block.vertices) {
    if (p.x() == end_m) top = std::max(top, p.y());
  }
  return top;
}

/// The ground block that is the highest on an end; -1: there is none.
int highest_ground(const Site& site, const scene::Scene& scene, double end_m) {
  int highest = -1;
  double top = -std::numeric_limits<double>::infinity();
  for (const int b : site.ground) {
    const double own = top_at(end_m, scene.blocks[static_cast<std::size_t>(b)]);
    if (own > top) highest = b;
    top = std::max(top, own);
  }
  return highest;
}

double find_bed(const Site& site, const scene::Scene& scene, double end_m, const std::optional<scene::BedCorner>& end) {
  const int ground = highest_ground(site, scene, end_m);
  if (ground < 0) return -std::numeric_limits<double>::infinity();
  const double own = top_at(end_m, scene.blocks[static_cast<std::size_t>(ground)]);
  if (!end) return own;
  const auto& outline = scene.blocks[static_cast<std::size_t>(end->block)].vertices;
  return std::max(own, outline[static_cast<std::size_t>(end->vertex)].y());
}

/// Ground beyond the end, as high as the bed and as far as `to_m`, joined to a block whose face there is lower.
void raise(std::vector<scene::Point>& outline, double end_m, double to_m, double bed_m) {
  double top = -std::numeric_limits<double>::infinity();
  for (const scene::Point& p : outline) {
    if (p.x() == end_m) top = std::max(top, p.y());
  }
  std::vector<scene::Point> raised;
  for (const scene::Point& p : outline) {
    if (p.x() != end_m) {
      raised.push_back(p);
      continue;
    }
    const scene::Point beyond(to_m, p.y() == top ? bed_m : p.y());
    const bool step = p.y() == top && bed_m > top;
    if (step && to_m < end_m) raised.insert(raised.end(), {p, {end_m, bed_m}});
    raised.push_back(beyond);
    if (step && to_m > end_m) raised.insert(raised.end(), {{end_m, bed_m}, p});
  }
  outline.swap(raised);
}

}  // namespace

bool Site::is_ground(std::size_t block) const {
  return std::find(ground.begin(), ground.end(), static_cast<int>(block)) != ground.end();
}

Site find_site(const scene::Scene& scene) {
  Site site;
  site.model = scene::bounds_of(scene);
  site.highest_m = highest_water(scene);
  site.ground = find_ground(scene, site.model, site.highest_m);
  const scene::GroundEnds ends = scene::find_ground_ends(scene);
  site.bed_left_m = find_bed(site, scene, site.model.low.x(), ends.left);
  site.bed_right_m = find_bed(site, scene, site.model.high.x(), ends.right);
  const double bed = std::min(site.bed_left_m, site.bed_right_m);
  site.loose_left_m = site.structure_left_m = site.model.high.x();
  site.loose_right_m = site.structure_right_m = site.model.low.x();
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (site.is_ground(b)) continue;
    const geometry::Bounds block = geometry::bounds_of(scene.blocks[b].vertices);
    site.loose_left_m = std::min(site.loose_left_m, block.low.x());
    site.loose_right_m = std::max(site.loose_right_m, block.high.x());
    if (block.high.y() <= bed) continue;
    site.structure_left_m = std::min(site.structure_left_m, block.low.x());
    site.structure_right_m = std::max(site.structure_right_m, block.high.x());
  }
  if (site.structure_left_m > site.structure_right_m) {  // no structure on the bed
    site.structure_left_m = site.loose_left_m;
    site.structure_right_m = site.loose_right_m;
  }
  return site;
}

std::vector<std::vector<scene::Point>> outlines_up_to(double left_m, double right_m, const Site& site,
                                                      const scene::Scene& scene) {
  std::vector<std::vector<scene::Point>> outlines;
  for (const scene::Block& block : scene.blocks) outlines.push_back(block.vertices);
  const double low = site.model.low.x();
  const double high = site.model.high.x();
  const int at_left = highest_ground(site, scene, low);
  const int at_right = highest_ground(site, scene, high);
  for (const int b : site.ground) {
    auto& outline = outlines[static_cast<std::size_t>(b)];
    const scene::Block& block = scene.blocks[static_cast<std::size_t>(b)];
    raise(outline, low, std::min(low, left_m), b == at_left ? site.bed_left_m : top_at(low, block));
    raise(outline, high, std::max(high, right_m), b == at_right ? site.bed_right_m : top_at(high, block));
  }
  return outlines;
}

}  // namespace blockweir::openfoam
