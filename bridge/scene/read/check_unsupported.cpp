// SPDX-License-Identifier: GPL-3.0-or-later
// Reports blocks that would fall for ever, since nothing holds them.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bridge/scene/block_index.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/check.hpp"

namespace blockweir::scene {
namespace {

constexpr double touching_ratio = 1e-6;

/// Lowest and highest point of an outline on the vertical line at x; low > high where it misses.
std::pair<double, double> extent_at(const std::vector<Point>& outline, double x) {
  std::pair<double, double> extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    if ((a.x() > x) == (b.x() > x)) continue;
    const double y = a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
    extent = {std::min(extent.first, y), std::max(extent.second, y)};
  }
  return extent;
}

/// Whether a vertical line meets `upper` above `lower`. As the two do not overlap, their order can only change at the
/// x of a vertex: one line between each two of those says all.
bool lies_above(const Block& upper, const Block& lower) {
  std::vector<double> stations;
  for (const Block* block : {&upper, &lower}) {
    for (const Point& p : block->vertices) stations.push_back(p.x());
  }
  std::sort(stations.begin(), stations.end());
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    if (stations[i] == stations[i + 1]) continue;
    const double x = (stations[i] + stations[i + 1]) / 2;
    if (extent_at(lower.vertices, x).first < extent_at(upper.vertices, x).second) return true;
  }
  return false;
}

bool touch(const Block& a, const Block& b) {
  const double size = std::min(geometry::bounds_of(a.vertices).size(), geometry::bounds_of(b.vertices).size());
  return !trace_joint(a, b, touching_ratio * size).pieces.empty();
}

std::vector<bool> held_by_themselves(const Scene& scene) {
  std::vector<bool> held;
  const bool water = scene.fluid != FluidModel::none;
  for (const Block& block : scene.blocks) {
    const bool known = block.material >= 0;
    const bool floats =
        water && known &&
        scene.materials[static_cast<std::size_t>(block.material)].density_kg_per_m3 < scene.water.density_kg_per_m3;
    held.push_back(block.fixed || floats);
  }
  for (const Support& support : scene.supports) {
    if (support.block >= 0 && support.displacement_y_m) held[static_cast<std::size_t>(support.block)] = true;
  }
  for (const ViscousFace& face : scene.viscous_faces) {
    if (!face.is_side()) held[static_cast<std::size_t>(face.block)] = true;
  }
  for (const Bolt& bolt : scene.bolts) {
    if (bolt.blocks[0] >= 0 && bolt.blocks[1] < 0) held[static_cast<std::size_t>(bolt.blocks[0])] = true;
  }
  return held;
}

/// "block "a" is", "3 blocks ("a", "b", "c") are", of many the first few.
std::string falling_blocks(const std::vector<const Block*>& blocks) {
  constexpr std::size_t most = 3;
  if (blocks.size() == 1) return fmt::format("block \"{}\" is", blocks.front()->name);
  std::string names;
  for (std::size_t i = 0; i < std::min(most, blocks.size()); ++i) {
    names += fmt::format("{}\"{}\"", i > 0 ? ", " : "", blocks[i]->name);
  }
  if (blocks.size() > most) names += fmt::format(" and {} more", blocks.size() - most);
  return fmt::format("{} blocks ({}) are", blocks.size(), names);
}

/// The blocks turned so that gravity points down the y axis.
std::vector<Block> upright(const Scene& scene) {
  std::vector<Block> blocks = scene.blocks;
  const Point down = scene.analysis.gravity().normalized();
  for (Block& block : blocks) {
    for (Point& p : block.vertices) p = Point(down.x() * p.y() - down.y() * p.x(), -down.dot(p));
  }
  return blocks;
}

}  // namespace

void check_unsupported(const Scene& scene, Problems& problems) {
  if (scene.analysis.gravity_m_per_s2 == 0) return;
  const std::vector<Block> blocks = scene.analysis.gravity_tilt_deg == 0 ? scene.blocks : upright(scene);
  BlockIndex open(blocks);  // those not yet held
  std::vector<bool> held = held_by_themselves(scene);
  std::vector<std::size_t> holding;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) continue;
    holding.push_back(i);
    if (!blocks[i].vertices.empty()) open.forget(i, blocks[i]);
  }
  auto left = static_cast<std::size_t>(std::count(held.begin(), held.end(), false));
  while (!holding.empty() && left > 0) {
    const std::size_t at = holding.back();
    const Block& holder = blocks[at];
    holding.pop_back();
    const auto hold = [&](std::size_t i) {
      if (held[i]) return;
      held[i] = true;
      --left;
      holding.push_back(i);
      if (!blocks[i].vertices.empty()) open.forget(i, blocks[i]);
    };
    for (const Bolt& bolt : scene.bolts) {
      const auto [a, b] = bolt.blocks;
      if (a < 0 || b < 0) continue;
      if (static_cast<std::size_t>(a) == at) hold(static_cast<std::size_t>(b));
      if (static_cast<std::size_t>(b) == at) hold(static_cast<std::size_t>(a));
    }
    geometry::Bounds reach = geometry::bounds_of(holder.vertices);
    const Point margin = Point::Constant(touching_ratio * reach.size());
    reach = {reach.low - margin, reach.high + margin};
    reach.high.y() = std::numeric_limits<double>::max();
    for (const std::size_t i : open.meeting(reach)) {
      if (lies_above(blocks[i], holder) || touch(blocks[i], holder)) hold(i);
    }
  }
  std::vector<const Block*> falling;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) falling.push_back(&scene.blocks[i]);
  }
  if (falling.empty()) return;
  problems.error(problems.at(falling.front()->line),
                 falling_blocks(falling) + " outside any support: nothing that holds is below or beside",
                 "a fixed block or a support in y that they touch or lie above, or other blocks in between",
                 "add a foundation with fixed = true, fixed_base = true to a [[wall]], or a [[support]] with "
                 "displacement_y_m = 0");
}

}  // namespace blockweir::scene
