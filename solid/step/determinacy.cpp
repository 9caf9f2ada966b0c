// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/determinacy.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "solid/solve/islands.hpp"

namespace blockweir::solid {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Displacement that the group's weight, put on the block's own width, causes over its height [m].
double elastic_displacement(const scene::Scene& scene, const Block& block, const scene::Material& material,
                            double weight) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& v : block.vertices) box.extend(v);
  const double water = scene.fluid == scene::FluidModel::none
                           ? 0
                           : scene.water.density_kg_per_m3 * scene.analysis.gravity_m_per_s2 * box.sizes().y();
  return (weight / box.sizes().x() + water) / material.youngs_modulus_pa * box.sizes().maxCoeff();
}

}  // namespace

std::vector<bool> rigid_blocks(const scene::Scene& scene, const std::vector<Block>& blocks,
                               const std::vector<ContactPoint>& contacts) {
  const scene::Rigid rule = scene.analysis.rigid;
  std::vector<bool> rigid(blocks.size());
  std::vector<bool> fixed(scene.blocks.size());
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    fixed[b] = blocks[b].fixed;
    rigid[b] = !fixed[b] && !blocks[b].meshed &&
               (rule == scene::Rigid::all || (rule != scene::Rigid::none && scene.blocks[b].rigid));
  }
  if (rule != scene::Rigid::automatic) return rigid;

  std::set<std::pair<int, int>> faces;
  for (const ContactPoint& c : contacts) {
    if (c.state != ContactState::open) faces.insert(std::minmax(c.vertex_block, c.edge_block));
  }
  const std::vector<std::pair<int, int>> links(faces.begin(), faces.end());
  std::vector<int> supports;
  for (const scene::Support& s : scene.supports) supports.push_back(s.block);
  for (const Island& group : find_islands(fixed, links, supports)) {
    double weight = 0;
    for (const int b : group.blocks) weight += blocks[at(b)].mass_per_m() * scene.analysis.gravity_m_per_s2;
    const bool determinate = group.contacts.size() + group.supports.size() <= group.blocks.size();
    for (const int b : group.blocks) {
      const scene::Material& material = scene.materials[at(scene.blocks[at(b)].material)];
      const double displacement = elastic_displacement(scene, blocks[at(b)], material, weight);
      if (determinate && !blocks[at(b)].meshed && displacement < 1e-2 * scene.analysis.failure_displacement_m)
        rigid[at(b)] = true;
    }
  }
  return rigid;
}

}  // namespace blockweir::solid
