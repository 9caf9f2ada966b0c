// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/determinacy.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "bridge/scene/at.hpp"
#include "bridge/scene/viscous_ground.hpp"
#include "solid/solve/islands.hpp"

namespace blockweir::solid {
namespace {

double largest(const scene::TimeTable& course) {
  double size = 0;
  for (const double value : course.value) size = std::max(size, std::abs(value));
  return size + (course.sine ? std::abs(course.sine->amplitude) : 0);
}

/// Sum of the largest forces that the scene itself puts on a block, weight among them. Water comes on top.
double largest_load(const scene::Scene& scene, const Block& block, int index) {
  const double mass = block.mass_per_m();
  double sum = mass * scene.analysis.gravity_m_per_s2;
  for (const auto& load : scene.point_loads) {
    if (load.block == index) sum += largest(load.force_x_n_per_m) + largest(load.force_y_n_per_m);
  }
  for (const auto& load : scene.face_pressures) {
    const double pressure = largest(load.pressure_from_pa) + largest(load.pressure_to_pa);
    if (load.block == index) sum += pressure / 2 * (load.to_m - load.from_m).norm();
  }
  for (const auto& load : scene.line_loads) {
    if (load.block != index) continue;
    for (const auto& end : {load.force_from_n_per_m2, load.force_to_n_per_m2}) {
      for (const auto& axis : end) sum += largest(axis) / 2 * (load.to_m - load.from_m).norm();
    }
  }
  for (const auto& load : scene.body_loads) {
    if (std::find(load.blocks.begin(), load.blocks.end(), index) == load.blocks.end()) continue;
    for (const auto& axis : load.value) sum += largest(axis) * (load.per_mass ? mass : block.area);
  }
  if (const auto& base = scene.base_motion) {
    sum += mass * (largest(base->acceleration_x_m_per_s2) + largest(base->acceleration_y_m_per_s2));
  }
  return sum;
}

/// Displacement over the block's size that its group's loads cause, all put on the block's own width [m].
double elastic_displacement(const scene::Scene& scene, const Block& block, const scene::Material& material,
                            double load) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& v : block.vertices) box.extend(v);
  const double water = scene.fluid == scene::FluidModel::none
                           ? 0
                           : scene.water.density_kg_per_m3 * scene.analysis.gravity_m_per_s2 * box.sizes().y();
  return (load / box.sizes().minCoeff() + water) / material.youngs_modulus_pa * box.sizes().maxCoeff();
}

/// A bolt is one support more.
bool bolted(const scene::Scene& scene, int block) {
  return std::any_of(scene.bolts.begin(), scene.bolts.end(),
                     [&](const scene::Bolt& bolt) { return bolt.blocks[0] == block || bolt.blocks[1] == block; });
}

/// What only a block that strains can show.
bool must_strain(const Block& block) {
  return block.meshed || !block.initial_stress.isZero(0);
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
    if (c.state != ContactState::open) faces.insert(c.pair());
  }
  const std::vector<std::pair<int, int>> links(faces.begin(), faces.end());
  std::vector<int> supports;
  for (const scene::Support& s : scene.supports) supports.push_back(s.block);
  for (const Island& group : find_islands(fixed, links, supports)) {
    double load = 0;
    bool free_to_choose = group.contacts.size() + group.supports.size() <= group.blocks.size();
    for (const int b : group.blocks) {
      load += largest_load(scene, blocks[at(b)], b);
      free_to_choose =
          free_to_choose && !must_strain(blocks[at(b)]) && !bolted(scene, b) && !scene::is_viscous_ground(scene, b);
    }
    for (const int b : group.blocks) {
      const scene::Material& material = scene.materials[at(scene.blocks[at(b)].material)];
      const double displacement = elastic_displacement(scene, blocks[at(b)], material, load);
      if (free_to_choose && displacement < 1e-2 * scene.analysis.failure_displacement_m) rigid[at(b)] = true;
    }
  }
  return rigid;
}

}  // namespace blockweir::solid
