// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks through whose joints still water flows, and what presses in a joint.
#pragma once

#include "tests/still_water.hpp"

namespace blockweir::tests {

inline constexpr double weight_n_per_m3 = 9810;
inline constexpr double aperture = 2e-4;

/// Blocks by these outlines, the first of them fixed; water flows through all joints.
inline scene::Scene flowing(const std::vector<std::vector<Point>>& outlines, double upstream_m) {
  scene::Scene scene = scene_of(outlines, upstream_m);
  scene.blocks[0].fixed = true;
  scene.default_joint.uplift = scene::Uplift::flow;
  scene.default_joint.hydraulic_aperture_m = aperture;
  scene.analysis.gravity_m_per_s2 = 9.81;
  scene.water.elements_per_face = 1;
  return scene;
}

inline wire::Motion at_rest(const scene::Scene& scene) {
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  return motion;
}

struct JointWater {
  double force = 0;   ///< N/m
  double moment = 0;  ///< about the edge's first vertex, N
};

/// Of the water in joints, along an edge of a block.
inline JointWater joint_water(const scene::Scene& scene, const wire::Load& load, std::uint32_t block,
                              std::uint32_t edge) {
  const auto& outline = scene.blocks[block].vertices;
  const double length = (outline[(edge + 1) % outline.size()] - outline[edge]).norm();
  JointWater sum;
  for (std::size_t i = load.cracks_from; i < load.block.size(); ++i) {
    if (load.block[i] != block || load.edge[i] != edge) continue;
    const double a = length * load.s_from[i];
    const double b = length * load.s_to[i];
    const double p = load.pressure_from_pa[i];
    const double q = load.pressure_to_pa[i];
    sum.force += (b - a) * (p + q) / 2;
    sum.moment += (b - a) / 6 * (p * (2 * a + b) + q * (a + 2 * b));
  }
  return sum;
}

inline const std::vector<Point> ground = {{-20, -5}, {30, -5}, {30, 0}, {-20, 0}};

}  // namespace blockweir::tests
