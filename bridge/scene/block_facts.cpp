// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/block_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::scene {

const Block& block_named(const Scene& scene, const std::string& name) {
  for (const Block& block : scene.blocks) {
    if (block.name == name) return block;
  }
  throw std::runtime_error(fmt::format("[[expect]] of = \"{}\" names no block", name));
}

const Joint& joint_named(const Scene& scene, const std::string& name) {
  for (const Joint& joint : scene.joints) {
    if (joint.name == name) return joint;
  }
  throw std::runtime_error(fmt::format("[[expect]] of = \"{}\" names no joint", name));
}

bool flows_in_joints(const Scene& scene) {
  const auto flows = [](const JointLaw& law) { return law.uplift == Uplift::flow; };
  return flows(scene.default_joint) ||
         std::any_of(scene.joints.begin(), scene.joints.end(), [&](const Joint& j) { return flows(j.law); });
}

const Material& material_of(const Scene& scene, const Block& block) {
  return scene.materials[at(block.material)];
}

double weight(const Scene& scene, const Block& block) {
  return geometry::signed_area(block.vertices) * material_of(scene, block).density_kg_per_m3 *
         scene.analysis.gravity_m_per_s2;
}

double height(const Block& block) {
  const auto [low, high] = std::minmax_element(block.vertices.begin(), block.vertices.end(),
                                               [](const Point& p, const Point& q) { return p.y() < q.y(); });
  return high->y() - low->y();
}

geometry::Bounds bounds_of(const Scene& scene) {
  geometry::Bounds all = geometry::bounds_of(scene.blocks.front().vertices);
  for (const Block& block : scene.blocks) {
    const geometry::Bounds one = geometry::bounds_of(block.vertices);
    all = {all.low.cwiseMin(one.low), all.high.cwiseMax(one.high)};
  }
  return all;
}

}  // namespace blockweir::scene
