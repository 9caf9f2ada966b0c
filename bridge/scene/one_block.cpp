// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/one_block.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

double height_of(const Block& block) {
  return geometry::centroid(block.vertices).y();
}

/// Does downstream water ever reach above y?
bool has_tailwater(const Scene& scene, double y) {
  constexpr int looks = 1000;
  if (!scene.water.downstream_level_m) return false;
  for (int i = 0; i <= looks; ++i) {
    if (scene.water.downstream_level_m->at(scene.analysis.duration_s * i / looks) > y) return true;
  }
  return false;
}

}  // namespace

std::string beyond_one_block(const Scene& scene, const Joint& joint) {
  const auto block = [&](int i) -> const Block& { return scene.blocks[static_cast<std::size_t>(i)]; };
  if (joint.between[0] < 0 || joint.between[1] < 0) return {};
  if (block(joint.between[0]).vertices.empty() || block(joint.between[1]).vertices.empty()) return {};
  const bool first = height_of(block(joint.between[0])) > height_of(block(joint.between[1]));
  const Block& upper = block(joint.between[first ? 0 : 1]);
  const double touching_m = 1e-6 * structure_size_m(scene.blocks);
  for (const Block& other : scene.blocks) {
    if (&other == &upper || other.fixed || other.vertices.empty() || height_of(other) <= height_of(upper)) continue;
    if (trace_joint(upper, other, touching_m).pieces.empty()) continue;
    return fmt::format("leaves out block \"{}\", which stands on block \"{}\"", other.name, upper.name);
  }
  const auto lower = [](const Point& a, const Point& b) { return a.y() < b.y(); };
  const double base_m = std::min_element(upper.vertices.begin(), upper.vertices.end(), lower)->y();
  if (has_tailwater(scene, base_m)) {
    return fmt::format("leaves out the tailwater, which presses block \"{}\" above {:.4g} m", upper.name, base_m);
  }
  return {};
}

}  // namespace blockweir::scene
