// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes that the solid's verification is built from, and how to run them.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

inline scene::Scene empty_scene() {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  return scene;
}

inline void add(scene::Scene& scene, std::vector<Point> vertices, bool fixed = false) {
  scene::Block block;
  block.name = "b" + std::to_string(scene.blocks.size());
  block.vertices = std::move(vertices);
  block.fixed = fixed;
  scene.blocks.push_back(block);
}

inline void run(Solid& solid, double duration_s, const std::vector<Panel>& water = {}) {
  const double dt = solid.scene().analysis.step_s;
  const auto steps = std::lround(duration_s / dt);
  for (long n = 0; n < steps; ++n) solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, water);
}

}  // namespace blockweir::solid
