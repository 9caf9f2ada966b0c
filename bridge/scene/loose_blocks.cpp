// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/loose_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "bridge/scene/block_index.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

/// How near blocks have to be to hold each other.
struct Reach {
  double touching_m;  ///< as the faces of a joint
  double falling_m;   ///< a gap that closes by less does not count
  Point down;         ///< of unit length

  /// Across a gap to its side a block falls.
  [[nodiscard]] bool over(const Point& gap) const {
    return gap.norm() <= touching_m || gap.squaredNorm() <= falling_m * std::abs(gap.dot(down));
  }
};

/// Of blocks that do not overlap the nearest points are a corner of one and an edge of the other.
bool near(const Block& a, const Block& b, const Reach& reach) {
  for (const auto& [corners, edges] : {std::pair(&a.vertices, &b.vertices), std::pair(&b.vertices, &a.vertices)}) {
    for (const Point& corner : *corners) {
      for (std::size_t i = 0; i < edges->size(); ++i) {
        const Point& to = (*edges)[(i + 1) % edges->size()];
        if (reach.over(geometry::nearest_on_segment(corner, (*edges)[i], to) - corner)) return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<bool> held_by_themselves(const Scene& scene) {
  std::vector<bool> held;
  for (const Block& block : scene.blocks) {
    const bool floats = scene.fluid != FluidModel::none &&
                        scene.materials[at(block.material)].density_kg_per_m3 < scene.water.density_kg_per_m3;
    held.push_back(block.fixed || floats);
  }
  for (const Support& support : scene.supports) held[at(support.block)] = true;
  for (const ViscousFace& face : scene.viscous_faces) held[at(face.block)] = true;
  for (const Bolt& bolt : scene.bolts) {
    if (bolt.blocks[1] < 0) held[at(bolt.blocks[0])] = true;
  }
  return held;
}

std::vector<int> blocks_not_held(const Scene& scene) {
  if (scene.analysis.gravity_m_per_s2 == 0) return {};
  const Reach reach{1e-6 * structure_size_m(scene.blocks), scene.analysis.failure_displacement_m,
                    scene.analysis.gravity().normalized()};
  std::vector<bool> held = held_by_themselves(scene);
  BlockIndex open(scene.blocks);  // not yet known to be held
  std::vector<std::size_t> holding;
  const auto hold = [&](std::size_t b) {
    held[b] = true;
    holding.push_back(b);
    open.forget(b, scene.blocks[b]);
  };
  for (std::size_t b = 0; b < held.size(); ++b) {
    if (held[b]) hold(b);
  }
  while (!holding.empty()) {
    const std::size_t holder = holding.back();
    holding.pop_back();
    for (const Bolt& bolt : scene.bolts) {
      const auto& [a, b] = bolt.blocks;
      if (a < 0 || b < 0) continue;
      if (at(a) == holder && !held[at(b)]) hold(at(b));
      if (at(b) == holder && !held[at(a)]) hold(at(a));
    }
    geometry::Bounds around = geometry::bounds_of(scene.blocks[holder].vertices);
    around.low.array() -= std::max(reach.touching_m, reach.falling_m);
    around.high.array() += std::max(reach.touching_m, reach.falling_m);
    for (const std::size_t b : open.meeting(around)) {
      if (near(scene.blocks[b], scene.blocks[holder], reach)) hold(b);
    }
  }
  std::vector<int> loose;
  for (std::size_t b = 0; b < held.size(); ++b) {
    if (!held[b]) loose.push_back(static_cast<int>(b));
  }
  return loose;
}

std::vector<int> loose_blocks(const Scene& scene) {
  std::vector<int> loose = blocks_not_held(scene);
  const auto fixed = std::count_if(scene.blocks.begin(), scene.blocks.end(), [](const Block& b) { return b.fixed; });
  const bool any_stands = loose.size() + static_cast<std::size_t>(fixed) < scene.blocks.size();
  return any_stands ? loose : std::vector<int>();
}

std::string loose_text(const Scene& scene, const std::vector<int>& loose) {
  constexpr std::size_t most = 3;
  if (loose.size() == 1) return fmt::format("block \"{}\" falls from the start", scene.blocks[at(loose[0])].name);
  std::string names;
  for (std::size_t i = 0; i < std::min(most, loose.size()); ++i) {
    const bool last = i + 1 == loose.size();
    names += fmt::format("{}\"{}\"", i == 0 ? "" : last ? " and " : ", ", scene.blocks[at(loose[i])].name);
  }
  if (loose.size() > most) names += fmt::format(" and {} more", loose.size() - most);
  return fmt::format("{} blocks ({}) fall from the start", loose.size(), names);
}

std::string hold_loose_blocks(Scene& scene) {
  const std::vector<int> loose = loose_blocks(scene);
  if (loose.empty()) return {};
  for (const int b : loose) scene.blocks[at(b)].fixed = true;
  return loose_text(scene, loose) +
         ", as nothing holds what the scene draws there. This answer is that of the other blocks, before anything "
         "falls on them; leave the loose ones out, or draw what they rest on";
}

}  // namespace blockweir::scene
