// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks in still water, and what presses on them.
#pragma once

#include <string>
#include <vector>

#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "solid/block/panel.hpp"

namespace blockweir::tests {

using scene::Point;

inline scene::Scene scene_of(std::vector<std::vector<Point>> outlines, double level) {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  for (auto& outline : outlines) {
    scene::Block block;
    block.name = "b" + std::to_string(scene.blocks.size());
    block.vertices = std::move(outline);
    scene.blocks.push_back(block);
  }
  scene.water.upstream_level_m = scene::TimeTable::constant(level);
  return scene;
}

inline wire::Load load_at_rest(const scene::Scene& scene) {
  hydrostatic::HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  wire::Load load;
  model.advance(motion, 0, load);
  return load;
}

struct Resultant {
  Point force = Point::Zero();
  double moment = 0;  ///< about the origin, counter-clockwise
};

inline Resultant resultant(const scene::Scene& scene, const wire::Load& load, std::uint32_t on) {
  Resultant r;
  for (std::size_t i = 0; i < load.block.size(); ++i) {
    if (load.block[i] != on) continue;
    const auto block = solid::make_block(scene.blocks[on], scene.materials[0], scene::Plane::strain);
    const solid::Placement placement(block.centroid, solid::Vector6::Zero());
    const auto acting = solid::panel_force(block, placement,
                                           {static_cast<int>(on), static_cast<int>(load.edge[i]), load.s_from[i],
                                            load.s_to[i], load.pressure_from_pa[i], load.pressure_to_pa[i]},
                                           scene.water.nodal_rule);
    for (std::size_t k = 0; k < 2; ++k) {
      const Point x = placement.position(acting.node[k]);
      r.force += acting.force[k];
      r.moment += x.x() * acting.force[k].y() - x.y() * acting.force[k].x();
    }
  }
  return r;
}

}  // namespace blockweir::tests
