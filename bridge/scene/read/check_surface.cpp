// SPDX-License-Identifier: GPL-3.0-or-later
// A pool of model = "reservoir" that blocks cover from wall to dam: shut in, its pressure has no answer.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// What of a line lies within a block, along that line [m].
struct Covered {
  double from_m;
  double to_m;
  std::size_t block;
};

/// Of the line along `axis` (0: x, 1: y) on which the other coordinate is `at_m`; in order.
std::vector<Covered> covered(const std::vector<Block>& blocks, int axis, double at_m) {
  std::vector<Covered> all;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::vector<Point>& outline = blocks[b].vertices;
    std::vector<double> crossed;
    for (std::size_t v = 0; v < outline.size(); ++v) {
      const Point& p = outline[v];
      const Point& q = outline[(v + 1) % outline.size()];
      const double p_off = p[1 - axis] - at_m;
      const double q_off = q[1 - axis] - at_m;
      if ((p_off > 0) != (q_off > 0)) crossed.push_back(p[axis] + p_off / (p_off - q_off) * (q[axis] - p[axis]));
    }
    std::sort(crossed.begin(), crossed.end());
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) all.push_back({crossed[i], crossed[i + 1], b});
  }
  std::sort(all.begin(), all.end(), [](const Covered& a, const Covered& b) { return a.from_m < b.from_m; });
  return all;
}

/// Is more than `gap_m` free on one stretch?
bool is_free(const std::vector<Covered>& covered, double from_m, double to_m, double gap_m) {
  double done_m = from_m;
  for (const Covered& c : covered) {
    if (std::min(c.from_m, to_m) - done_m > gap_m) return true;
    done_m = std::max(done_m, c.to_m);
  }
  return to_m - done_m > gap_m;
}

Point crest_of(const std::vector<Block>& blocks) {
  Point crest = blocks.front().vertices.front();
  for (const Block& block : blocks) {
    for (const Point& p : block.vertices) crest = p.y() > crest.y() ? p : crest;
  }
  return crest;
}

void check(const Reading& reading, const char* key, const std::optional<double>& wall_m,
           const std::optional<TimeTable>& level) {
  constexpr double inside = 1e-7;  // of the size
  if (!wall_m || !level) return;
  const std::vector<Block>& blocks = reading.scene.blocks;
  geometry::Bounds model = geometry::bounds_of(blocks.front().vertices);
  for (const Block& block : blocks) {
    const geometry::Bounds own = geometry::bounds_of(block.vertices);
    model = {model.low.cwiseMin(own.low), model.high.cwiseMax(own.high)};
  }
  const double gap_m = reading.scene.water.open_crack_width_m;
  const double level_m = level->at(0);
  const double tiny_m = inside * model.size();
  const double crest_m = crest_of(blocks).x();
  const double left_m = std::min(*wall_m, crest_m);
  const double right_m = std::max(*wall_m, crest_m);
  const std::vector<Covered> roof = covered(blocks, 0, level_m - tiny_m);
  if (is_free(roof, left_m, right_m, gap_m)) return;
  const double at_wall_m = *wall_m == left_m ? left_m + tiny_m : right_m - tiny_m;
  if (!is_free(covered(blocks, 1, at_wall_m), model.low.y(), level_m, gap_m)) return;  // no water there
  const auto longest = std::max_element(roof.begin(), roof.end(), [&](const Covered& a, const Covered& b) {
    const auto length = [&](const Covered& c) { return std::min(c.to_m, right_m) - std::max(c.from_m, left_m); };
    return length(a) < length(b);
  });
  reading.problems.error(
      reading.problems.at(reading.file["fluid"]["reservoir"][key].node()->source()),
      fmt::format("the pool before {} has no surface: block \"{}\" covers it at its level, {:g} m", key,
                  blocks[longest->block].name, level_m),
      "a free surface on each pool",
      fmt::format("lower the level, shorten the block, or leave {} out: the pool is long then", key));
}

}  // namespace

void check_surface(const Reading& reading) {
  const Scene& scene = reading.scene;
  if (scene.fluid != FluidModel::reservoir) return;
  check(reading, "upstream_wall_m", scene.reservoir.upstream_wall_m, scene.water.upstream_level_m);
  check(reading, "downstream_wall_m", scene.reservoir.downstream_wall_m, scene.water.downstream_level_m);
}

}  // namespace blockweir::scene
